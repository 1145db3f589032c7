#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

EditState initialState(SceneDescription scene, const RequestOverrides& overrides,
                       const std::optional<SceneBounds>& bounds) {
    const RenderRequest request =
        requestFor(std::make_shared<const SceneDescription>(std::move(scene)), overrides);
    return {request.scene, request.settings, request.camera, bounds ? *bounds : boundsOf(*request.scene)};
}

std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights) {
    SceneDescription edited = scene;
    edited.lights = std::move(lights);
    return std::make_shared<const SceneDescription>(std::move(edited));
}

}  // namespace rayscope::viewer
