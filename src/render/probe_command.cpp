#include "render/probe_command.h"

#include <fmt/format.h>

#include <vector>

#include "base/printable_text.h"
#include "base/shell_quote.h"
#include "render/scene_defaults.h"

namespace rayscope::render {

namespace {

/// Options that turn the scene's default camera into the request's.
std::string cameraOptions(const SceneDescription& scene, const CameraDescription& camera) {
    std::string text;
    CameraDescription known = defaultCamera(scene);
    for (const CameraDescription& candidate : scene.cameras)
        if (candidate.name == camera.name && camera.name != known.name) {
            text += " --camera " + base::shellQuote(camera.name);
            known = candidate;
            break;
        }
    if (camera.lookFrom != known.lookFrom) text += " --look-from " + optionText(camera.lookFrom);
    if (camera.lookAt != known.lookAt) text += " --look-at " + optionText(camera.lookAt);
    if (camera.up != known.up) text += " --up " + optionText(camera.up);
    if (camera.fov != known.fov) text += fmt::format(" --fov {}", camera.fov);
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

/// The command without the pixel and the sample.
std::string commandPrefix(const RenderRequest& request) {
    std::string text = fmt::format("rayscope probe {} --size {}x{}",
                                   base::shellQuotePath(request.scene->path), request.width, request.height);
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
            .beforeX = commandPrefix(request) + " --pixel ",
            .beforeY = ",",
            .beforeIndex = " --sample "};
}

std::string probeCommand(const RenderRequest& request, const SampleId& sample) {
    return fmt::format("{} --pixel {},{} --sample {}", commandPrefix(request), sample.x, sample.y,
                       sample.index);
}

}  // namespace rayscope::render
