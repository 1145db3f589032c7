#include "cli/scene_options.h"

#include <fmt/format.h>

#include <span>

#include "cli/command_line.h"
#include "cli/load_progress.h"
#include "cli/number_list.h"
#include "scene/mesh_files/read_mesh_file.h"

namespace rayscope::cli {

std::string sceneOptionHelp() {
    const std::vector<std::string> suffixes = sceneFileSuffixes();
    return fmt::format("A scene ({}), a mesh ({}), or builtin:NAME", suffixes.front(),
                       fmt::join(std::span(suffixes).subspan(1), ", "));
}

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
    Option& positional = list.add("SCENE", &scene, sceneOptionHelp());
    if (sceneRequired) positional.required();
    list.add("-t,--threads,--nthreads", &threads, "Tracing threads; 0 takes one per core")
        .range(0, 1024)
        .showDefault();
    list.add("-D,--set", &assignments, "Any setting of 'rayscope settings', as KEY=VALUE; repeatable");
}

namespace {

std::optional<glm::vec3> optionalVector(const std::string& option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    return parseVector(option, text);
}

SettingAssignment parseAssignment(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw UsageError("--set", fmt::format("expected KEY=VALUE, got '{}'", text));
    return {text.substr(0, equals), text.substr(equals + 1), {}};
}

}  // namespace

RequestOverrides overridesOf(const SceneOptions& options) {
    RequestOverrides overrides;
    overrides.camera = {options.camera, optionalVector("--look-from", options.lookFrom),
                        optionalVector("--look-at", options.lookAt), optionalVector("--up", options.up),
                        options.fov};
    overrides.preset = options.preset;
    for (const std::string& text : options.assignments) overrides.settings.push_back(parseAssignment(text));
    overrides.spp = options.spp;
    const glm::ivec2 size = parsePair("--size", options.size, 'x', 1);
    if (static_cast<long long>(size.x) * size.y > kMaxImagePixels)
        throw UsageError("--size", "more than 2^28 pixels");
    overrides.width = size.x;
    overrides.height = size.y;
    overrides.seed = options.seed;
    checkOverrides(overrides);
    return overrides;
}

RenderRequest openScene(const SceneOptions& options, bool quiet, ProgressStyle style) {
    Diagnostics notes;
    const RequestOverrides overrides = overridesOf(options);
    RenderRequest request = openRequest(options.scene, overrides, notes, LoadProgress(style).control());
    if (!quiet)
        for (const Diagnostic& note : notes) fmt::print(stderr, "{}\n", toString(note));
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
