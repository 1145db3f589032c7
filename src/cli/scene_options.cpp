#include "cli/scene_options.h"

#include <fmt/format.h>

#include <span>

#include "base/console.h"
#include "base/printable_text.h"
#include "cli/command_line.h"
#include "cli/load_progress.h"

namespace rayscope::cli {

namespace {

/// Far more than a picture has, and few enough that sums of two do not overflow.
constexpr int kLargestEdge = 1 << 20;

/// The row of the settings table.
SettingInfo settingNamed(std::string_view key) {
    for (const SettingInfo& info : describeSettings())
        if (info.key == key) return info;
    throw std::logic_error("no such setting");
}

std::vector<std::string> presetNames() {
    std::vector<std::string> names;
    for (const Preset& preset : presets()) names.emplace_back(preset.name);
    return names;
}

/// "KEY=" for numbers, else "KEY=VALUE" for every value.
std::vector<std::string> assignmentsToSettings() {
    std::vector<std::string> texts;
    for (const SettingInfo& info : describeSettings()) {
        std::vector<std::string_view> values = info.choices;
        if (info.kind == "boolean") values = {"true", "false"};
        if (values.empty()) values = {""};
        for (const std::string_view value : values) texts.push_back(fmt::format("{}={}", info.key, value));
    }
    return texts;
}

}  // namespace

std::vector<std::string> builtinSceneNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back("builtin:" + scene.name);
    return names;
}

std::string sceneOptionHelp() {
    const std::vector<std::string> suffixes = sceneFileSuffixes();
    return fmt::format("A scene ({}), a mesh ({}), or builtin:NAME", suffixes.front(),
                       fmt::join(std::span(suffixes).subspan(1), ", "));
}

void SceneOptions::addTo(OptionList& list, bool sceneRequired) {
    addSceneTo(list, sceneRequired);
    list.add("--size", &size, "Width and height of the image in pixels")
        .form("WxH", 'x')
        .from(1, kLargestEdge)
        .showDefault();
    list.add("--camera", &camera, "Name of a camera of the scene; by default the first");
    list.add("--look-from", &lookFrom, "Position of the camera").form("X,Y,Z", ',');
    list.add("--look-at", &lookAt, "Point that the camera looks at").form("X,Y,Z", ',');
    list.add("--up", &up, "Direction that is up in the image").form("X,Y,Z", ',');
    list.add("--fov", &fov, "Vertical angle of view in degrees").above(0.0).below(180.0);
    list.add("--lens", &lens, "Lens of the camera: f-number, focal length and focus distance in scene units")
        .form("F,FOCAL,DISTANCE", ',')
        .above(0.0);
    const SettingInfo samples = settingNamed("spp");
    list.add("--spp,--samples", &spp, "Samples per pixel").from(samples.lowest, samples.highest);
    list.add("--preset", &preset,
             "Settings that trade speed for accuracy: preview, balanced, final or reference; --set and --spp "
             "override it")
        .suggest(presetNames);
    list.add("--seed", &seed, "Seed of the random numbers").showDefault();
}

void SceneOptions::addSceneTo(OptionList& list, bool sceneRequired) {
    Option& positional = list.add("SCENE", &scene, sceneOptionHelp()).suggest(builtinSceneNames);
    if (sceneRequired) positional.required();
    addThreadsTo(list, threads);
    addSettingsTo(list, assignments);
}

void addThreadsTo(OptionList& list, int& threads) {
    list.add("-t,--threads,--nthreads", &threads, "Threads; 0 takes one per core")
        .from(0, 1024)
        .showDefault();
}

void addSettingsTo(OptionList& list, std::vector<std::string>& assignments) {
    list.add("-D,--set", &assignments, "Any setting of 'rayscope settings'; repeatable")
        .form("KEY=VALUE")
        .suggest(assignmentsToSettings);
}

void addProgressTo(OptionList& list, std::string& progress) {
    list.add("--progress", &progress, "How progress is shown").choices({"bar", "json", "none"});
}

namespace {

SettingAssignment parseAssignment(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw UsageError("--set", fmt::format("expected KEY=VALUE, got {}", base::quoted(text)));
    return {text.substr(0, equals), text.substr(equals + 1), {}};
}

}  // namespace

RequestOverrides overridesOf(const SceneOptions& options) {
    RequestOverrides overrides;
    overrides.camera = {options.camera, options.lookFrom, options.lookAt, options.up, options.fov, {}};
    if (const std::optional<glm::vec3>& lens = options.lens)
        overrides.camera.lens = Lens{lens->x, lens->y, lens->z};
    overrides.preset = options.preset;
    for (const std::string& text : options.assignments) overrides.settings.push_back(parseAssignment(text));
    overrides.spp = options.spp;
    const glm::ivec2 size = options.size;
    if (const long long pixels = static_cast<long long>(size.x) * size.y; pixels > kMaxImagePixels)
        throw UsageError("--size", fmt::format("{}x{} are {} pixels; at most {} are possible", size.x, size.y,
                                               pixels, kMaxImagePixels));
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
        for (const Diagnostic& note : notes) base::printMessage("{}\n", toString(note));
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
