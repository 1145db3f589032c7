#include <fmt/format.h>

#include <rayscope/open_request.h>

#include <algorithm>

#include "base/nearest_name.h"
#include "render/scene_defaults.h"
#include "shading/light_sample.h"

namespace rayscope {

namespace {

CameraDescription cameraNamed(const SceneDescription& scene, const std::string& name) {
    if (name.empty()) return render::defaultCamera(scene);
    std::vector<std::string_view> names;
    for (const CameraDescription& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names.push_back(camera.name);
    }
    throw InputError(fmt::format("{} has no camera '{}'{}; it has {}", scene.path, name,
                                 base::didYouMean(name, names), base::joinChoices(names)));
}

CameraDescription cameraFor(const SceneDescription& scene, const CameraOverrides& overrides) {
    CameraDescription camera = cameraNamed(scene, overrides.name);
    camera.lookFrom = overrides.lookFrom.value_or(camera.lookFrom);
    camera.lookAt = overrides.lookAt.value_or(camera.lookAt);
    camera.up = overrides.up.value_or(camera.up);
    camera.fov = overrides.fov.value_or(camera.fov);
    if (overrides.lens) camera.lens = overrides.lens;
    render::checkCamera(camera);
    return camera;
}

/// The last step: what overrides the preset.
void assignOverrides(Settings& settings, const RequestOverrides& overrides) {
    render::assignAll(settings, overrides.settings);
    if (overrides.spp) assign(settings, "spp", std::to_string(*overrides.spp));
}

/// Notes lights that are so long in the units of the scene that their number of samples is capped.
void noteCappedLights(const RenderRequest& request, Diagnostics& notes) {
    const std::vector<Light>& lights = request.scene->lights;
    const auto isCapped = [&](const Light& light) { return shading::isCapped(light, request.settings); };
    const auto first = std::find_if(lights.begin(), lights.end(), isCapped);
    if (first == lights.end()) return;
    notes.push_back(
        {Severity::Note,
         fmt::format(
             "light_sample_count=per_length: {} of {} lights take the most samples, {} along a segment "
             "or {} x {} over a parallelogram; the first is light {}; scale the scene down or lower the "
             "samples per length",
             std::count_if(first, lights.end(), isCapped), lights.size(), shading::kMostSegmentSamples,
             shading::kMostParallelogramSamples, shading::kMostParallelogramSamples,
             first - lights.begin() + 1),
         {request.scene->path}});
}

}  // namespace

void checkOverrides(const RequestOverrides& overrides) {
    if (!overrides.preset.empty()) presetNamed(overrides.preset);
    Settings unused;
    assignOverrides(unused, overrides);
}

RenderRequest requestFor(std::shared_ptr<const SceneDescription> scene, const RequestOverrides& overrides) {
    RenderRequest request;
    request.width = overrides.width;
    request.height = overrides.height;
    request.seed = overrides.seed;
    request.camera = cameraFor(*scene, overrides.camera);
    request.settings = render::settingsOf(*scene);
    if (!overrides.preset.empty())
        applyPreset(request.settings, presetNamed(overrides.preset),
                    blursPixels(requirementsOf(*scene), request.camera));
    assignOverrides(request.settings, overrides);
    request.scene = std::move(scene);
    return request;
}

RenderRequest openRequest(const std::string& scene, const RequestOverrides& overrides, Diagnostics& notes,
                          const LoadControl& control) {
    checkOverrides(overrides);  // before the scene is read, which may take long
    RenderRequest request =
        requestFor(std::make_shared<const SceneDescription>(loadScene(scene, notes, control)), overrides);
    noteCappedLights(request, notes);
    return request;
}

}  // namespace rayscope
