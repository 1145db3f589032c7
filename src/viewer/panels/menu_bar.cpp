#include <fmt/format.h>

#include <cstring>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

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
        if (ui::menuItem(info.label, shortcutText(info).c_str(), info.checked && info.checked(workspace),
                         !info.enabled || info.enabled(workspace)))
            workspace.commands.push_back(info.command);
        tooltip(info.help);
        if (info.command == Command::OpenScene) {
            drawBuiltinMenu(workspace);
            drawRecentMenu(workspace);
        }
    }
}

void drawResolutions(Workspace& workspace) {
    ImGui::Separator();
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
            if (std::strcmp(menu, "View") == 0) drawResolutions(workspace);
        });
    }
    ImGui::EndMainMenuBar();
}

}  // namespace rayscope::viewer
