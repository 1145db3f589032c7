// The dial from fast to accurate. Its positions were chosen from the fronts of the shipped scenes:
// docs/trade.md has the figures.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/settings.h>

#include "base/nearest_name.h"

namespace rayscope {

namespace {

using Values = std::vector<std::pair<std::string_view, std::string_view>>;

/// Each sample of a pixel takes few samples of everything within it: that way errors fall fastest for the
/// time, because samples of the pixel and of lights are stratified together.
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
    // Reflections of reflections of reflections are below the noise that is left, and where surfaces also let
    // light through each doubles the work.
    static const std::vector<Preset> kPresets{
        {"preview", "a first look: one sample per pixel, two reflections", values("1", "2", "4", "2", "2"),
         kOnePerLight},
        {"balanced", "good to look at", values("8", "3", "4", "2", "2"), kOnePerLight},
        {"final", "good to print", values("64", "3", "8", "2", "2"), kOnePerLight},
        {"reference", "to judge others by", values("1024", "16", "1", "1", "1"), {}}};
    return kPresets;
}

const Preset& presetNamed(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset;
        names.push_back(preset.name);
    }
    throw InputError(fmt::format("unknown preset '{}': expected {}{}", name, base::joinChoices(names),
                                 base::didYouMean(name, names)));
}

void applyPreset(Settings& settings, const Preset& preset, bool blurred) {
    for (const auto& [key, value] : preset.values) assign(settings, key, value);
    if (!blurred) return;
    for (const auto& [key, value] : preset.valuesIfBlurred) assign(settings, key, value);
}

}  // namespace rayscope
