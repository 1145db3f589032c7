#include <fmt/format.h>

#include <cstring>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

bool isEnabled(const Workspace& workspace, Command command) {
    if (command == Command::Undo) return workspace.history.canUndo();
    if (command == Command::Redo) return workspace.history.canRedo();
    const bool hasSelection = !workspace.rays.selection().empty();
    if (command == Command::HideRay || command == Command::IsolateRay) return hasSelection;
    if (command == Command::ClearRays || command == Command::CopyRays || command == Command::ExportRays ||
        command == Command::PinPixel)
        return workspace.rays.recording() != nullptr;
    if (command == Command::ComparePictures || command == Command::FlipPictures)
        return workspace.comparison.a() != nullptr;
    return true;
}

bool isTicked(const Workspace& workspace, Command command) {
    const ViewState& view = workspace.view;
    switch (command) {
        case Command::SwitchView:
            return view.traced;
        case Command::ToggleOverlay:
            return view.overlay;
        case Command::ToggleWireframe:
            return view.raster.wireframe;
        case Command::ToggleSidePanel:
            return view.sidePanel;
        case Command::FlyMode:
            return view.flying;
        case Command::PauseOrResume:
            return workspace.render.paused();
        case Command::ToggleLiveRay:
            return view.liveRay;
        case Command::ToggleHeatMap:
            return workspace.heat.shown;
        case Command::ComparePictures:
            return workspace.comparison.visible();
        case Command::ToggleTraversal:
            return workspace.rays.traversal.shown;
        case Command::IsolateRay:
            return workspace.rays.filter.isolated;
        case Command::ToggleBvhLevels:
            return workspace.bvh.shown.levels;
        case Command::ShowKeys:
            return view.showKeys;
        case Command::ShowStatistics:
            return view.showStatistics;
        default:
            return false;
    }
}

void drawBuiltinMenu(Workspace& workspace) {
    static const std::vector<BuiltinScene> scenes = builtinScenes();
    ui::menu("Built-in scenes", [&] {
        for (const BuiltinScene& scene : scenes) {
            if (ui::menuItem(scene.name.c_str())) workspace.open("builtin:" + scene.name);
            tooltip(scene.title);
        }
    });
}

void drawRecentMenu(Workspace& workspace) {
    std::string chosen;
    const auto drawPaths = [&] {
        for (const std::string& path : workspace.recent.paths())
            if (ui::menuItem(path.c_str())) chosen = path;
    };
    ui::menu("Recent", drawPaths, !workspace.recent.paths().empty());
    if (!chosen.empty()) workspace.open(chosen);
}

void drawCommands(Workspace& workspace, const char* menu) {
    for (const CommandInfo& info : commandTable()) {
        if (std::strcmp(info.menu, menu) != 0) continue;
        if (info.separatorBefore) ImGui::Separator();
        if (ui::menuItem(info.label, shortcutText(info).c_str(), isTicked(workspace, info.command),
                         isEnabled(workspace, info.command)))
            workspace.commands.push_back(info.command);
        tooltip(info.help);
        if (info.command == Command::OpenScene) {
            drawBuiltinMenu(workspace);
            drawRecentMenu(workspace);
        }
    }
}

void drawRasterChoices(Workspace& workspace) {
    ImGui::Separator();
    ui::menuItem("Smooth normals", nullptr, &workspace.view.raster.smoothNormals);
    ui::menuItem("Textures", nullptr, &workspace.view.raster.textures);
    ui::menu("Resolution of the traced view", [&] {
        for (const float resolution : {1.0f, 0.5f, 0.25f})
            if (ui::menuItem(fmt::format("{:.0f} %", 100.0f * resolution).c_str(), nullptr,
                             workspace.view.resolution == resolution))
                workspace.view.resolution = resolution;
    });
}

}  // namespace

void drawMenuBar(Workspace& workspace) {
    if (!ImGui::BeginMainMenuBar()) return;
    const ui::Scope scope("Menu");
    for (const char* menu : {"File", "Edit", "View", "Camera", "Rays", "BVH", "Help"}) {
        ui::menu(menu, [&] {
            drawCommands(workspace, menu);
            if (std::strcmp(menu, "View") == 0) drawRasterChoices(workspace);
        });
    }
    ImGui::EndMainMenuBar();
}

}  // namespace rayscope::viewer
