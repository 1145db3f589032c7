#include "viewer/model/edit_state.h"

#include <fmt/format.h>

#include "base/nearest_name.h"

namespace rayscope::viewer {

namespace {

void assignAll(Settings& settings, const std::vector<SettingAssignment>& assignments) {
    for (const SettingAssignment& assignment : assignments) {
        try {
            assign(settings, assignment.key, assignment.value);
        } catch (const InputError& error) {
            throw InputError(error.diagnostic().message, assignment.position);
        }
    }
}

CameraDescription chooseCamera(const SceneDescription& scene, const std::string& name) {
    if (name.empty()) return scene.cameras.empty() ? framingCamera(boundsOf(scene)) : scene.cameras.front();
    std::vector<std::string_view> names;
    for (const CameraDescription& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
    }
    throw InputError(fmt::format("the scene has no camera '{}'{}", name, base::didYouMean(name, names)));
}

}  // namespace

EditState initialState(SceneDescription scene, const std::vector<SettingAssignment>& settings,
                       const CameraOverrides& overrides, const std::string& preset) {
    EditState state;
    state.camera = chooseCamera(scene, overrides.name);
    assignAll(state.settings, scene.settings);
    if (!preset.empty())
        applyPreset(state.settings, presetNamed(preset), blursPixels(requirementsOf(scene), state.camera));
    assignAll(state.settings, settings);
    state.camera.lookFrom = overrides.lookFrom.value_or(state.camera.lookFrom);
    state.camera.lookAt = overrides.lookAt.value_or(state.camera.lookAt);
    state.camera.up = overrides.up.value_or(state.camera.up);
    state.camera.fov = overrides.fov.value_or(state.camera.fov);
    state.scene = std::make_shared<const SceneDescription>(std::move(scene));
    return state;
}

std::shared_ptr<const SceneDescription> withLights(const SceneDescription& scene, std::vector<Light> lights) {
    SceneDescription edited = scene;
    edited.lights = std::move(lights);
    return std::make_shared<const SceneDescription>(std::move(edited));
}

}  // namespace rayscope::viewer
