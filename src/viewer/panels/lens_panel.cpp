#include "math/vectors.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

void drawLensRows(Workspace& workspace) {
    CameraDescription& camera = workspace.edit.camera;
    bool hasLens = camera.lens.has_value();
    labelledRow("Lens");
    if (ui::checkbox("##lens", &hasLens)) {
        camera.lens.reset();
        // Wide enough for a visible blur, focused at the point that the camera looks at.
        if (hasLens) {
            const auto distance = static_cast<float>(math::distance(camera.lookFrom, camera.lookAt));
            camera.lens = Lens{1.4f, 0.05f * distance, distance};
        }
    }
    tooltip("A thin lens blurs everything out of focus; without one the camera is a pinhole.");
    if (!camera.lens) {
        ImGui::SameLine();
        dimText("tick to add a lens");
        return;
    }
    constexpr ImGuiSliderFlags kFlags = kClamp | ImGuiSliderFlags_Logarithmic;
    labelledRow("f-number");
    ui::sliderFloat("##fNumber", &camera.lens->fNumber, 0.1f, 64.0f, "%.2g", kFlags);
    labelledRow("Focal length");
    ui::dragFloat("##focal", &camera.lens->focalLength, 0.01f * camera.lens->focalLength, 1e-6f, 1e6f, "%.4g",
                  kClamp);
    labelledRow("Focus distance");
    ui::dragFloat("##focus", &camera.lens->focusDistance, 0.01f * camera.lens->focusDistance, 1e-6f, 1e9f,
                  "%.4g", kClamp);
    if (ui::button("Focus on a pixel...", {-1.0f, 0.0f})) workspace.commands.push_back(Command::FocusOnPixel);
    tooltip(infoOf(Command::FocusOnPixel).help);
}

}  // namespace rayscope::viewer
