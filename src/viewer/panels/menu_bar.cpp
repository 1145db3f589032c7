#include <fmt/format.h>

#include <cstring>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawBuiltinMenu(Workspace& workspace) {
    static const std::vector<BuiltinScene> scenes = builtinScenes();
    if (!ImGui::BeginMenu("Built-in scenes")) return;
    for (const BuiltinScene& scene : scenes) {
        if (ImGui::MenuItem(scene.name.c_str())) workspace.open("builtin:" + scene.name);
        tooltip(scene.title);
    }
    ImGui::EndMenu();
}

void drawRecentMenu(Workspace& workspace) {
    if (!ImGui::BeginMenu("Recent", !workspace.recent.paths().empty())) return;
    std::string chosen;
    for (const std::string& path : workspace.recent.paths())
        if (ImGui::MenuItem(path.c_str())) chosen = path;
    if (!chosen.empty()) workspace.open(chosen);
    ImGui::EndMenu();
}

void drawCommands(Workspace& workspace, const char* menu) {
    for (const CommandInfo& info : commandTable()) {
        if (std::strcmp(info.menu, menu) != 0) continue;
        if (info.separatorBefore) ImGui::Separator();
        if (ImGui::MenuItem(info.label, shortcutText(info).c_str(), info.checked && info.checked(workspace),
                            !info.enabled || info.enabled(workspace)))
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
    ImGui::MenuItem("Smooth normals", nullptr, &workspace.view.raster.smoothNormals);
    ImGui::MenuItem("Textures", nullptr, &workspace.view.raster.textures);
    if (!ImGui::BeginMenu("Resolution of the traced view")) return;
    for (const float resolution : {1.0f, 0.5f, 0.25f})
        if (ImGui::MenuItem(fmt::format("{:.0f} %", 100.0f * resolution).c_str(), nullptr,
                            workspace.view.resolution == resolution))
            workspace.view.resolution = resolution;
    ImGui::EndMenu();
}

}  // namespace

void drawMenuBar(Workspace& workspace) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "View", "Camera", "Rays", "BVH", "Help"}) {
        if (!ImGui::BeginMenu(menu)) continue;
        drawCommands(workspace, menu);
        if (std::strcmp(menu, "View") == 0) drawRasterChoices(workspace);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

}  // namespace rayscope::viewer
