#include "viewer/model/edit_state.h"

#include <algorithm>

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

bool isSameView(const RenderRequest& a, const RenderRequest& b) {
    Settings settings = a.settings;
    settings.spp = b.settings.spp;
    return a.scene == b.scene && a.camera == b.camera && a.seed == b.seed &&
           changed(settings, b.settings) <= Invalidates::Display;
}

bool isSameView(const RenderRequest& a, const EditState& b) {
    return isSameView(a, requestOf(b, a.width, a.height));
}

bool isSameFrame(const RenderRequest& a, const RenderRequest& b) {
    return isSameView(a, b) && a.width == b.width && a.height == b.height;
}

RenderRequest previewOf(const RenderRequest& full, int divisor) {
    RenderRequest preview = full;
    preview.width = std::max(1, full.width / divisor);
    preview.height = std::max(1, full.height / divisor);
    preview.settings.spp = 1;
    return preview;
}

std::optional<int> previewDivisor(const RenderRequest& preview, const RenderRequest& full) {
    for (int divisor = 1; divisor <= kCoarsestDivisor; divisor *= 2)
        if (isSameFrame(preview, previewOf(full, divisor))) return divisor;
    return std::nullopt;
}

SceneDescription sceneOf(const EditState& state) {
    SceneDescription scene = *state.scene;
    const auto named = std::ranges::find(scene.cameras, state.camera.name, &CameraDescription::name);
    if (named != scene.cameras.end())
        *named = state.camera;
    else
        scene.cameras.insert(scene.cameras.begin(), state.camera);
    const Settings opened = requestFor(state.scene).settings;
    for (const std::string_view key : settingKeys()) {
        const std::string value = textOf(state.settings, key);
        if (value == textOf(opened, key)) continue;
        std::erase_if(scene.settings, [&](const SettingAssignment& s) { return s.key == key; });
        scene.settings.push_back({std::string(key), value, {}});
    }
    return scene;
}

std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights) {
    SceneDescription edited = scene;
    edited.lights = std::move(lights);
    edited.edited = true;
    return std::make_shared<const SceneDescription>(std::move(edited));
}

}  // namespace rayscope::viewer
