#include "render/probe_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "base/printable_text.h"
#include "base/shell_quote.h"
#include "render/scene_defaults.h"
#include "sampling/sample_stream.h"

namespace rayscope::render {

namespace {

/// The camera of the scene with this name, or its default camera.
CameraDescription knownCamera(const SceneDescription& scene, const std::string& name) {
    CameraDescription known = defaultCamera(scene);
    for (const CameraDescription& candidate : scene.cameras)
        if (candidate.name == name && name != known.name) return candidate;
    return known;
}

/// Options that turn the scene's default camera into the request's.
std::string cameraOptions(const SceneDescription& scene, const CameraDescription& camera) {
    std::string text;
    const CameraDescription known = knownCamera(scene, camera.name);
    if (known.name != defaultCamera(scene).name) text += " --camera " + base::shellQuote(known.name);
    if (camera.lookFrom != known.lookFrom) text += " --look-from " + optionText(camera.lookFrom);
    if (camera.lookAt != known.lookAt) text += " --look-at " + optionText(camera.lookAt);
    if (camera.up != known.up) text += " --up " + optionText(camera.up);
    if (camera.fov != known.fov) text += fmt::format(" --fov {}", camera.fov);
    if (camera.lens && camera.lens != known.lens) text += " --lens " + optionText(*camera.lens);
    return text;
}

/// KEY=VALUE of the settings that differ from what the scene file sets, or from the defaults.
std::vector<std::string> changedSettings(const RenderRequest& request) {
    const Settings ofScene = settingsOf(*request.scene);
    std::vector<std::string> assignments;
    for (const std::string_view key : settingKeys()) {
        const std::string value = textOf(request.settings, key);
        if (value != textOf(ofScene, key)) assignments.push_back(fmt::format("{}={}", key, value));
    }
    return assignments;
}

/// The command on a scene, without outputs or samples.
std::string commandPrefix(std::string_view command, const std::string& scene, const RenderRequest& request) {
    std::string text = fmt::format("rayscope {} {} --size {}x{}", command, base::shellQuotePath(scene),
                                   request.width, request.height);
    text += cameraOptions(*request.scene, request.camera);
    if (request.seed != 0) text += fmt::format(" --seed {}", request.seed);
    for (const std::string& assignment : changedSettings(request))
        text += " --set " + base::shellQuote(assignment);
    return text;
}

}  // namespace

CrashContext crashContextOf(const RenderRequest& request) {
    const std::vector<std::string> assignments = changedSettings(request);
    return {.scene = fmt::format("{}, {} x {} pixels, seed {}", base::printable(request.scene->path),
                                 request.width, request.height, request.seed),
            .settings = assignments.empty() ? "those of the scene, or defaults"
                                            : fmt::format("{}", fmt::join(assignments, " ")),
            .beforeX = commandPrefix("probe", request.scene->path, request) + " --pixel ",
            .beforeY = ",",
            .beforeIndex = " --sample "};
}

std::string probeCommand(const RenderRequest& request, const SampleId& sample) {
    return fmt::format("{} --pixel {},{} --sample {}", commandPrefix("probe", request.scene->path, request),
                       sample.x, sample.y, sample.index);
}

std::optional<std::string> renderCommand(const RenderRequest& request, int samples) {
    const bool lensRemoved =
        !request.camera.lens && knownCamera(*request.scene, request.camera.name).lens.has_value();
    const bool unreached =
        sampling::dependsOnSampleCount(request.settings.sampler) && samples != request.settings.spp;
    if (request.scene->edited || lensRemoved || unreached || samples < 1) return std::nullopt;
    RenderRequest repeated = request;
    repeated.settings.spp = samples;
    std::string text =
        commandPrefix("render", std::filesystem::path(request.scene->path).filename().string(), repeated);
    if (const std::optional<PixelBounds>& region = request.region)
        text += fmt::format(" --pixelbounds {},{},{},{}", region->x0, region->x1, region->y0, region->y1);
    return text;
}

}  // namespace rayscope::render
