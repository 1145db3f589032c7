#include "cli/scene_options.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/nearest_name.h"
#include "base/shell_quote.h"
#include "cli/command_line.h"
#include "cli/number_list.h"

namespace rayscope::cli {

void SceneOptions::addTo(OptionList& list, bool sceneRequired) {
    addSceneTo(list, sceneRequired);
    list.add("--size", &size, "Width and height of the image in pixels, as WxH").showDefault();
    list.add("--camera", &camera, "Name of a camera of the scene; by default the first");
    list.add("--look-from", &lookFrom, "Position of the camera, as X,Y,Z");
    list.add("--look-at", &lookAt, "Point that the camera looks at, as X,Y,Z");
    list.add("--up", &up, "Direction that is up in the image, as X,Y,Z");
    list.add("--fov", &fov, "Vertical angle of view in degrees").range(0.001, 179.0);
    list.add("--spp,--samples", &spp, "Samples per pixel");
    list.add("--preset", &preset,
             "Settings that trade speed for accuracy: preview, balanced, final or reference; --set and --spp "
             "override it");
    list.add("--seed", &seed, "Seed of the random numbers").showDefault();
}

void SceneOptions::addSceneTo(OptionList& list, bool sceneRequired) {
    Option& positional = list.add("SCENE", &scene, "A .toml scene, a bare .obj, or builtin:NAME");
    if (sceneRequired) positional.required();
    list.add("-t,--threads,--nthreads", &threads, "Tracing threads; 0 takes one per core")
        .range(0, 1024)
        .showDefault();
    list.add("-D,--set", &assignments, "Any setting of 'rayscope settings', as KEY=VALUE; repeatable");
}

namespace {

CameraDescription chooseCamera(const SceneDescription& scene, const SceneOptions& options) {
    CameraDescription camera = scene.cameras.front();
    if (!options.camera.empty()) {
        std::vector<std::string_view> names;
        const CameraDescription* found = nullptr;
        for (const CameraDescription& candidate : scene.cameras) {
            names.push_back(candidate.name);
            if (candidate.name == options.camera) found = &candidate;
        }
        if (!found)
            throw InputError(fmt::format("{} has no camera '{}'; it has {}", scene.path, options.camera,
                                         base::joinChoices(names)));
        camera = *found;
    }
    if (!options.lookFrom.empty()) camera.lookFrom = parseVector("--look-from", options.lookFrom);
    if (!options.lookAt.empty()) camera.lookAt = parseVector("--look-at", options.lookAt);
    if (!options.up.empty()) camera.up = parseVector("--up", options.up);
    if (options.fov) camera.fov = *options.fov;
    if (camera.lookFrom == camera.lookAt)
        throw InputError("the camera's look-from and look-at are the same point; move one of them");
    return camera;
}

Settings settingsFor(const SceneDescription& scene, const CameraDescription& camera,
                     const SceneOptions& options) {
    const std::vector<SettingAssignment> assignments = parseAssignments(options);
    Settings settings;
    for (const SettingAssignment& assignment : scene.settings)
        assign(settings, assignment.key, assignment.value);
    if (!options.preset.empty())
        applyPreset(settings, presetNamed(options.preset), blursPixels(requirementsOf(scene), camera));
    for (const SettingAssignment& assignment : assignments)
        assign(settings, assignment.key, assignment.value);
    return settings;
}

}  // namespace

std::vector<SettingAssignment> parseAssignments(const SceneOptions& options) {
    std::vector<SettingAssignment> list;
    if (!options.preset.empty()) presetNamed(options.preset);
    for (const std::string& text : options.assignments) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw UsageError("--set", fmt::format("expected KEY=VALUE, got '{}'", text));
        list.push_back({text.substr(0, equals), text.substr(equals + 1), {}});
    }
    if (options.spp) list.push_back({"spp", std::to_string(*options.spp), {}});
    Settings scratch;
    for (const SettingAssignment& assignment : list) assign(scratch, assignment.key, assignment.value);
    return list;
}

RenderRequest openScene(const SceneOptions& options, bool quiet) {
    Diagnostics notes;
    auto scene = std::make_shared<SceneDescription>(loadScene(options.scene, notes));
    if (!quiet)
        for (const Diagnostic& note : notes) fmt::print(stderr, "{}\n", toString(note));
    RenderRequest request;
    const glm::ivec2 size = parsePair("--size", options.size, 'x', 1);
    if (static_cast<std::int64_t>(size.x) * size.y > std::int64_t{1} << 28)
        throw UsageError("--size", "more than 2^28 pixels");
    request.width = size.x;
    request.height = size.y;
    request.camera = chooseCamera(*scene, options);
    request.settings = settingsFor(*scene, request.camera, options);
    request.seed = options.seed;
    request.scene = std::move(scene);
    return request;
}

std::string dumpSettings(const Settings& settings) {
    std::string text = "[settings]\n";
    const Settings defaults;
    for (const SettingInfo& info : describeSettings()) {
        const std::string value = textOf(settings, info.key);
        if (value == textOf(defaults, info.key)) continue;
        text += info.kind == "choice" ? fmt::format("{} = \"{}\"\n", info.key, value)
                                      : fmt::format("{} = {}\n", info.key, value);
    }
    return text;
}

std::string probeCommand(const SceneOptions& options, glm::ivec2 pixel, int sample) {
    std::string words = "rayscope probe";
    const auto add = [&](std::string_view option, const std::string& value) {
        if (value.empty()) return;
        if (!option.empty()) words += fmt::format(" {}", option);
        words += " " + base::shellQuote(value);
    };
    add("", options.scene);
    add("--size", options.size);
    add("--camera", options.camera);
    add("--look-from", options.lookFrom);
    add("--look-at", options.lookAt);
    add("--up", options.up);
    if (options.fov) add("--fov", fmt::format("{}", *options.fov));
    if (options.spp) add("--spp", fmt::format("{}", *options.spp));
    if (options.seed != 0) add("--seed", fmt::format("{}", options.seed));
    for (const std::string& assignment : options.assignments) add("--set", assignment);
    return words + fmt::format(" --pixel {},{} --sample {}", pixel.x, pixel.y, sample);
}

}  // namespace rayscope::cli
