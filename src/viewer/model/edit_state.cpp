#include "viewer/model/edit_state.h"

#include "viewer/model/viewer_seed.h"

namespace rayscope::viewer {

EditState initialState(SceneDescription scene, const RequestOverrides& overrides,
                       const std::optional<SceneBounds>& bounds) {
    const RenderRequest request =
        requestFor(std::make_shared<const SceneDescription>(std::move(scene)), overrides);
    return {request.scene, request.settings, request.camera, bounds ? *bounds : boundsOf(*request.scene)};
}

RenderRequest requestOf(const EditState& state, int width, int height) {
    RenderRequest request;
    request.scene = state.scene;
    request.settings = state.settings;
    request.camera = state.camera;
    request.width = width;
    request.height = height;
    request.seed = kViewerSeed;
    return request;
}

std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights) {
    SceneDescription edited = scene;
    edited.lights = std::move(lights);
    return std::make_shared<const SceneDescription>(std::move(edited));
}

}  // namespace rayscope::viewer
