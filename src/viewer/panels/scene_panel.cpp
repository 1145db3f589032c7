#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawSceneChoice(Workspace& workspace) {
    static const std::vector<BuiltinScene> scenes = builtinScenes();
    const std::string& path = workspace.edit.scene->path;
    const std::string shown = workspace.loader.busy() ? "opening " + workspace.loader.path() : path;
    ImGui::SetNextItemWidth(-scaled(64.0f));
    if (ImGui::BeginCombo("##scenes", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const BuiltinScene& scene : scenes) {
            const std::string name = "builtin:" + scene.name;
            if (ImGui::Selectable(scene.name.c_str(), name == path)) workspace.open(name);
            tooltip(scene.title);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    if (ImGui::Button("Open...", {-1.0f, 0.0f})) workspace.commands.push_back(Command::OpenScene);
}

/// "1 mesh", "5 materials"; nothing for none.
void appendCount(std::string& words, std::size_t count, const char* one, const char* many) {
    if (count == 0) return;
    if (!words.empty()) words += ", ";
    words += fmt::format("{} {}", count, count == 1 ? one : many);
}

void drawCounts(const SceneDescription& scene, const SceneRequirements& needs) {
    std::string words;
    appendCount(words, needs.triangles, "triangle", "triangles");
    appendCount(words, scene.meshes.size(), "mesh", "meshes");
    appendCount(words, needs.spheres, "sphere", "spheres");
    appendCount(words, scene.materials.size(), "material", "materials");
    appendCount(words, scene.lights.size(), "light", "lights");
    wrappedText(words.empty() ? "empty" : words);
}

void drawRequirements(const SceneRequirements& needs) {
    if (!ImGui::TreeNode("What it needs")) return;
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
