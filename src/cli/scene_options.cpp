#include "cli/scene_options.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/nearest_name.h"
#include "cli/number_list.h"

namespace rayscope::cli {

void SceneOptions::addTo(CLI::App& command, bool sceneRequired) {
    addSceneTo(command, sceneRequired);
    command.add_option("--size", size, "Width and height of the image in pixels, as WxH")
        ->capture_default_str();
    command.add_option("--camera", camera, "Name of one of the scene's cameras");
    command.add_option("--look-from", lookFrom, "Position of the camera, as X,Y,Z");
    command.add_option("--look-at", lookAt, "Point that the camera looks at, as X,Y,Z");
    command.add_option("--up", up, "Direction that is up in the image, as X,Y,Z");
    command.add_option("--fov", fov, "Vertical angle of view in degrees")->check(CLI::Range(0.001, 179.0));
    command.add_option("--spp,--samples", spp, "Samples per pixel");
    command.add_option(
        "--preset", preset,
        "Settings that trade speed for accuracy: preview, balanced, final or reference; --set and --spp "
        "go before it");
    command.add_option("--seed", seed, "Seed of the random numbers")->capture_default_str();
}

void SceneOptions::addSceneTo(CLI::App& command, bool sceneRequired) {
    auto* positional = command.add_option("SCENE", scene, "A .toml scene, a bare .obj, or builtin:NAME");
    if (sceneRequired) positional->required();
    command.add_option("-t,--threads,--nthreads", threads, "Tracing threads; 0 takes one per core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command
        .add_option("-D,--set", assignments, "Any setting of 'rayscope settings', as KEY=VALUE; repeatable")
        ->take_all()
        ->expected(1)
        ->allow_extra_args(false);
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
            throw CLI::ValidationError("--set", fmt::format("expected KEY=VALUE, got '{}'", text));
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
    if (static_cast<long long>(size.x) * size.y > kMaxImagePixels)
        throw CLI::ValidationError("--size", "more than 2^28 pixels");
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

}  // namespace rayscope::cli
