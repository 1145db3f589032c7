#include "viewer/app/command_actions.h"

#include <utility>

#include "trace/world.h"
#include "viewer/model/projection.h"

namespace rayscope::viewer {

namespace {

/// The point of the surface under the cursor.
std::optional<glm::dvec3> surfaceUnderCursor(const Workspace& workspace) {
    return workspace.cursor ? workspace.cursor->position : std::nullopt;
}

}  // namespace

void toggleHeatMap(Workspace& workspace) {
    toggle(workspace.heat.shown);
    workspace.view.traced |= workspace.heat.shown;
}

void toggleComparison(Workspace& workspace) {
    toggle(workspace.comparison.view.shown);
    workspace.view.traced |= workspace.comparison.visible();
}

void flipPictures(Workspace& workspace) {
    workspace.comparison.view.mode = CompareMode::Flip;
    toggle(workspace.comparison.view.flipped);
}

void resetCamera(Workspace& workspace) { workspace.edit.camera = requestFor(workspace.edit.scene).camera; }

void centerOnPixel(Workspace& workspace) {
    const auto surface = surfaceUnderCursor(workspace);
    if (!surface) return workspace.notify("Nothing is hit at this pixel", Severity::Warning);
    CameraDescription centered = workspace.edit.camera;
    centered.lookAt = glm::vec3(*surface);
    if (centered.lookAt != centered.lookFrom) workspace.edit.camera = centered;
}

void focusOnPixel(Workspace& workspace) {
    const auto surface = surfaceUnderCursor(workspace);
    CameraDescription& camera = workspace.edit.camera;
    if (!surface || !camera.lens) return workspace.notify("Nothing is hit at this pixel", Severity::Warning);
    const ViewFrame frame = viewFrame(camera, 1, 1);
    const double depth = glm::dot(*surface - frame.eye, frame.forward);
    if (depth > 0.0) camera.lens->focusDistance = static_cast<float>(depth);
}

void selectLeafUnderCursor(Workspace& workspace) {
    const std::shared_ptr<const trace::World> world = workspace.worldOfScene();
    if (!world || !workspace.cursor || workspace.cursor->primitive == kNoPrimitive) return;
    workspace.bvh.selectLeafOf(world->locatePrimitive(workspace.cursor->primitive).inGroup);
}

void cancel(Workspace& workspace) {
    if (workspace.loader.loading()) {
        workspace.cancelLoading();
        return;
    }
    ViewState& view = workspace.view;
    if (std::exchange(view.picking, std::nullopt)) return;
    for (bool* mode : {&view.showKeys, &view.showRenderWindow, &view.flying, &view.liveRay})
        if (std::exchange(*mode, false)) return;
    workspace.clearRays();
}

}  // namespace rayscope::viewer
