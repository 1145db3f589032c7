#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawSceneChoice(Workspace& workspace) {
    static const std::vector<BuiltinScene> scenes = builtinScenes();
    const std::string& path = workspace.edit.scene->path;
    const std::string shown = workspace.loader.loading() ? "loading " + workspace.loader.path() : path;
    ImGui::SetNextItemWidth(-scaled(64.0f));
    ui::noteRow("File");
    const auto drawScenes = [&] {
        for (const BuiltinScene& scene : scenes) {
            const std::string name = "builtin:" + scene.name;
            if (ui::selectable(scene.name.c_str(), name == path)) workspace.open(name);
            tooltip(scene.title);
        }
    };
    ui::combo("##scenes", shown.c_str(), drawScenes, ImGuiComboFlags_HeightLarge);
    ImGui::SameLine();
    if (ui::button("Open...", {-1.0f, 0.0f})) workspace.commands.push_back(Command::OpenScene);
}

/// Appends "1 mesh" or "5 materials"; nothing for a count of 0.
void appendCount(std::string& counts, std::size_t count, const char* one, const char* many) {
    if (count == 0) return;
    if (!counts.empty()) counts += ", ";
    counts += fmt::format("{} {}", count, count == 1 ? one : many);
}

void drawCounts(const SceneDescription& scene, const SceneRequirements& needs) {
    std::string counts;
    appendCount(counts, needs.triangles, "triangle", "triangles");
    appendCount(counts, scene.meshes.size(), "mesh", "meshes");
    appendCount(counts, needs.spheres, "sphere", "spheres");
    appendCount(counts, scene.materials.size(), "material", "materials");
    appendCount(counts, scene.lights.size(), "light", "lights");
    wrappedText(counts.empty() ? "empty" : counts);
}

void drawRequirements(const SceneRequirements& needs) {
    if (!ui::treeNode("Required features")) return;
    for (const Requirement& requirement : needs.list) {
        labelledRow(requirement.name, requirement.needed);
        ImGui::PushTextWrapPos(0.0f);
        if (requirement.needed)
            text(requirement.reason.empty() ? "needed" : requirement.reason);
        else
            dimText(requirement.reason.empty() ? "not needed" : requirement.reason);
        ImGui::PopTextWrapPos();
    }
    ImGui::TreePop();
}

void drawNotes(const Diagnostics& notes) {
    if (notes.empty() || !ImGui::TreeNode("notes", "Notes (%d)", static_cast<int>(notes.size()))) return;
    for (const Diagnostic& note : notes) {
        ImGui::PushStyleColor(ImGuiCol_Text, note.severity == Severity::Note ? kDimText : kWarningText);
        wrappedText(toString(note));
        ImGui::PopStyleColor();
    }
    ImGui::TreePop();
}

}  // namespace

void drawScenePanel(Workspace& workspace) {
    drawSceneChoice(workspace);
    const std::shared_ptr<const SceneDescription>& scene = workspace.edit.scene;
    if (!scene->title.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
        wrappedText(scene->title);
        ImGui::PopStyleColor();
    }
    const SceneRequirements& needs = workspace.needs();
    drawCounts(*scene, needs);
    drawRequirements(needs);
    drawNotes(workspace.sceneNotes);
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
