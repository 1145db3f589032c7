#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "math/vectors.h"
#include "scene/check_camera.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawCameraChoice(Workspace& workspace) {
    const std::vector<CameraDescription>& cameras = workspace.edit.scene->cameras;
    if (cameras.size() < 2) return;
    labelledRow("Scene camera");
    ui::combo("##camera", workspace.edit.camera.name.c_str(), [&] {
        for (const CameraDescription& camera : cameras)
            if (ui::selectable(camera.name.c_str(), camera.name == workspace.edit.camera.name))
                workspace.edit.camera = camera;
    });
}

/// Copies the camera as command-line options, and sets it from such options.
void drawCameraText(Workspace& workspace) {
    static std::string typed;
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ui::button("Copy as options", {half, 0.0f})) workspace.commands.push_back(Command::CopyCamera);
    tooltip("Copy the camera as command-line options (Shift+Ctrl+C).");
    ImGui::SameLine();
    if (ui::button("Set from options...", {half, 0.0f})) {
        typed = toOptions(workspace.edit.camera);
        ImGui::OpenPopup("cameraText");
    }
    if (!ImGui::BeginPopup("cameraText")) return;
    const ui::Scope scope("Camera options");
    static std::string errorMessage;
    text("Camera as command-line options:");
    ImGui::SetNextItemWidth(scaled(560.0f));
    const bool entered =
        ui::noted("Options", ImGui::InputText("##options", &typed, ImGuiInputTextFlags_EnterReturnsTrue));
    if (entered || ui::button("Set")) {
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
    const auto distance = static_cast<float>(math::distance(camera.lookFrom, camera.lookAt));
    drawCameraChoice(workspace);
    CameraDescription changed = camera;
    vectorRow("Position", changed.lookFrom, 0.005f * distance);
    vectorRow("Look at", changed.lookAt, 0.005f * distance);
    vectorRow("Up", changed.up, 0.01f);
    labelledRow("Field of view");
    ui::sliderFloat("##fov", &changed.fov, 1.0f, 170.0f, "%.1f deg", ImGuiSliderFlags_AlwaysClamp);
    tooltip("Vertical field of view (--fov).");
    valueRow("Lens",
             changed.lens ? fmt::format("focus at {:.4g}", changed.lens->focusDistance) : "none (pinhole)",
             "Depth of field and its lens are in the tab Settings, section Camera.");
    if (scene::problemOf(changed).empty()) camera = changed;
    drawCameraText(workspace);
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
