#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "viewer/model/camera_text.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawCameraChoice(Workspace& workspace) {
    const std::vector<CameraDescription>& cameras = workspace.edit.scene->cameras;
    if (cameras.size() < 2) return;
    labelledRow("Of the scene");
    if (!ImGui::BeginCombo("##camera", workspace.edit.camera.name.c_str())) return;
    for (const CameraDescription& camera : cameras)
        if (ImGui::Selectable(camera.name.c_str(), camera.name == workspace.edit.camera.name))
            workspace.edit.camera = camera;
    ImGui::EndCombo();
}

void drawLens(CameraDescription& camera) {
    bool hasLens = camera.lens.has_value();
    labelledRow("Lens");
    if (ImGui::Checkbox("##lens", &hasLens)) {
        camera.lens.reset();
        // A lens that is seen to do something: focused at what the camera looks at.
        if (hasLens) {
            const float distance = glm::distance(camera.lookFrom, camera.lookAt);
            camera.lens = Lens{1.4f, 0.05f * distance, distance};
        }
    }
    tooltip(
        "With a lens, what is not at the focus distance is blurred; without one the camera is a pinhole.");
    if (!camera.lens) return;
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
    labelledRow("f-number");
    ImGui::SliderFloat("##fNumber", &camera.lens->fNumber, 0.1f, 64.0f, "%.2g", kFlags);
    labelledRow("Focal length");
    ImGui::DragFloat("##focal", &camera.lens->focalLength, 0.01f * camera.lens->focalLength, 1e-6f, 1e6f,
                     "%.4g");
    labelledRow("Focus distance");
    ImGui::DragFloat("##focus", &camera.lens->focusDistance, 0.01f * camera.lens->focusDistance, 1e-6f, 1e9f,
                     "%.4g");
}

/// Copies the camera as text, and takes such text.
void drawCameraText(Workspace& workspace) {
    static std::string typed;
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ImGui::Button("Copy as options", {half, 0.0f})) workspace.commands.push_back(Command::CopyCamera);
    tooltip("Copies the camera as options of the command line (Shift+Ctrl+C).");
    ImGui::SameLine();
    if (ImGui::Button("Set from text...", {half, 0.0f})) {
        typed = toOptions(workspace.edit.camera);
        ImGui::OpenPopup("cameraText");
    }
    if (!ImGui::BeginPopup("cameraText")) return;
    static std::string errorMessage;
    text("Camera as options of the command line:");
    ImGui::SetNextItemWidth(scaled(560.0f));
    const bool entered = ImGui::InputText("##options", &typed, ImGuiInputTextFlags_EnterReturnsTrue);
    if (entered || ImGui::Button("Set")) {
        try {
            workspace.edit.camera = withOptions(workspace.edit.camera, typed);
            errorMessage.clear();
            ImGui::CloseCurrentPopup();
        } catch (const InputError& error) {
            errorMessage = error.what();
        }
    }
    if (!errorMessage.empty()) coloredText(kErrorText, errorMessage);
    ImGui::EndPopup();
}

}  // namespace

void drawCameraPanel(Workspace& workspace) {
    CameraDescription& camera = workspace.edit.camera;
    const float distance = glm::distance(camera.lookFrom, camera.lookAt);
    drawCameraChoice(workspace);
    CameraDescription changed = camera;
    vectorRow("Position", changed.lookFrom, 0.005f * distance);
    vectorRow("Look at", changed.lookAt, 0.005f * distance);
    vectorRow("Up", changed.up, 0.01f);
    labelledRow("Field of view");
    ImGui::SliderFloat("##fov", &changed.fov, 1.0f, 170.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp);
    tooltip("Vertical angle of view (--fov).");
    drawLens(changed);
    if (changed.lookFrom != changed.lookAt && glm::length(changed.up) > 0.0f) camera = changed;
    drawCameraText(workspace);
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
