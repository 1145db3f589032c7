#include "probe/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "probe/diagnosis_parts.h"

namespace rayscope::probe {

std::string_view nameOf(Symptom symptom) {
    constexpr std::string_view kNames[] = {"not a number", "black", "bright", "noisy", "slow"};
    return kNames[static_cast<int>(symptom)];
}

std::string_view nameOf(Cause cause) {
    constexpr std::string_view kNames[] = {"unknown",
                                           "nothing hit",
                                           "no light",
                                           "light blocked",
                                           "light behind the surface",
                                           "black surface",
                                           "bad normal",
                                           "strong light",
                                           "huge numbers",
                                           "rare bright paths",
                                           "gloss",
                                           "penumbra",
                                           "edge",
                                           "many rays",
                                           "expensive rays",
                                           "duplicate geometry"};
    return kNames[static_cast<int>(cause)];
}

std::string toText(const Diagnosis& why) {
    std::string words = fmt::format("{}, {}: {}\n", nameOf(why.symptom), nameOf(why.cause), why.sentence);
    for (const Evidence& e : why.evidence)
        words += fmt::format("  see sample {}, {} {}\n", e.sample, e.shadow >= 0 ? "shadow ray" : "ray",
                             std::max(e.node, e.shadow));
    return words;
}

int samplesToDiagnose(const Settings& settings) { return std::min(settings.spp, 64); }

std::vector<Diagnosis> diagnosePixel(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                                     const std::function<void()>& beforeSample) {
    const PixelEvidence pixel = gatherEvidence(world, seed, x, y, samples, beforeSample);
    std::vector<Diagnosis> all;
    const auto add = [&](std::optional<Diagnosis> found) {
        if (found) all.push_back(std::move(*found));
    };
    add(diagnoseNonFinite(pixel));
    if (all.empty()) {
        add(diagnoseBlack(pixel));
        add(diagnoseBright(pixel));
        add(diagnoseNoisy(pixel));
    }
    add(diagnoseSlow(pixel));
    return all;
}

}  // namespace rayscope::probe
