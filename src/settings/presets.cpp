// The presets, chosen from the Pareto fronts of the shipped scenes (docs/trade.md).
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/settings.h>

#include "base/nearest_name.h"

namespace rayscope {

namespace {

using Values = std::vector<std::pair<std::string_view, std::string_view>>;

/// Few light, glossy and lens samples per pixel sample: the error falls fastest with time that way, because
/// the samples of a pixel and of its lights are stratified together.
Values values(std::string_view spp, std::string_view depth, std::string_view segment,
              std::string_view parallelogram, std::string_view glossy) {
    return {{"spp", spp},
            {"max_depth", depth},
            {"segment_samples", segment},
            {"parallelogram_samples", parallelogram},
            {"glossy_samples", glossy},
            {"lens_samples", "1"},
            {"sampler", "sobol"}};
}

const Values kOnePerLight{{"segment_samples", "1"}, {"parallelogram_samples", "1"}};

}  // namespace

const std::vector<Preset>& presets() {
    // Deeper reflections contribute less than the remaining noise, and each level doubles the number of rays
    // where surfaces are also transparent.
    static const std::vector<Preset> kPresets{
        {"preview", "one sample per pixel, two reflections", values("1", "2", "4", "2", "2"), kOnePerLight},
        {"balanced", "moderate noise, for the screen", values("8", "3", "4", "2", "2"), kOnePerLight},
        {"final", "low noise, for print", values("64", "3", "8", "2", "2"), kOnePerLight},
        {"reference", "reference image for comparisons", values("1024", "16", "1", "1", "1"), {}}};
    return kPresets;
}

const Preset& presetNamed(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset;
        names.push_back(preset.name);
    }
    throw InputError(fmt::format("unknown preset '{}'{}; expected {}", name, base::didYouMean(name, names),
                                 base::joinChoices(names)));
}

void applyPreset(Settings& settings, const Preset& preset, bool blurred) {
    for (const auto& [key, value] : preset.values) assign(settings, key, value);
    if (!blurred) return;
    for (const auto& [key, value] : preset.valuesIfBlurred) assign(settings, key, value);
}

}  // namespace rayscope
