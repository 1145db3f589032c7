// The dial from fast to accurate. Its positions were chosen from the fronts of the shipped scenes:
// docs/trade.md has the figures.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/settings.h>

#include "base/nearest_name.h"

namespace rayscope {

const std::vector<Preset>& presets() {
    // Each sample of a pixel takes few samples of everything within it: that way errors fall fastest for the
    // time, because samples of the pixel, of lights and of the lens are stratified together. Reflections of
    // reflections of reflections are below the noise that is left, and where surfaces also let light through
    // each doubles the work.
    static const std::vector<Preset> kPresets{{"preview",
                                               "a first look: one sample per pixel, two reflections",
                                               {{"spp", "1"},
                                                {"max_depth", "2"},
                                                {"segment_samples", "4"},
                                                {"parallelogram_samples", "2"},
                                                {"glossy_samples", "2"},
                                                {"lens_samples", "1"},
                                                {"sampler", "sobol"}}},
                                              {"balanced",
                                               "good to look at",
                                               {{"spp", "8"},
                                                {"max_depth", "3"},
                                                {"segment_samples", "4"},
                                                {"parallelogram_samples", "2"},
                                                {"glossy_samples", "2"},
                                                {"lens_samples", "1"},
                                                {"sampler", "sobol"}}},
                                              {"final",
                                               "good to print",
                                               {{"spp", "64"},
                                                {"max_depth", "3"},
                                                {"segment_samples", "4"},
                                                {"parallelogram_samples", "2"},
                                                {"glossy_samples", "2"},
                                                {"lens_samples", "1"},
                                                {"sampler", "sobol"}}},
                                              {"reference",
                                               "to judge others by",
                                               {{"spp", "1024"},
                                                {"max_depth", "16"},
                                                {"segment_samples", "1"},
                                                {"parallelogram_samples", "1"},
                                                {"glossy_samples", "1"},
                                                {"lens_samples", "1"},
                                                {"sampler", "sobol"}}}};
    return kPresets;
}

const Preset& presetNamed(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset;
        names.push_back(preset.name);
    }
    throw InputError(
        fmt::format("unknown preset '{}': expected {}{}", name, joinChoices(names), didYouMean(name, names)));
}

void applyPreset(Settings& settings, const Preset& preset) {
    for (const auto& [key, value] : preset.values) assign(settings, key, value);
}

}  // namespace rayscope
