#include "probe/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/printable_text.h"
#include "probe/diagnosis_parts.h"

namespace rayscope::probe {

std::string_view nameOf(Symptom symptom) {
    constexpr std::string_view kNames[] = {"not a number", "black", "bright", "noisy", "slow"};
    return kNames[static_cast<int>(symptom)];
}

std::string_view nameOf(Cause cause) {
    constexpr std::string_view kNames[] = {
        "unknown",           "nothing hit", "no light",     "light occluded", "light behind the surface",
        "black material",    "bad normal",  "strong light", "overflow",       "rare bright paths",
        "glossy reflection", "penumbra",    "edge",         "many rays",      "expensive rays",
        "duplicate geometry"};
    return kNames[static_cast<int>(cause)];
}

std::string toText(const Diagnosis& diagnosis) {
    std::string text = fmt::format("{}, {}: {}\n", nameOf(diagnosis.symptom), nameOf(diagnosis.cause),
                                   base::printable(diagnosis.sentence));
    for (const Evidence& e : diagnosis.evidence)
        text += fmt::format("  see sample {}, {} {}\n", e.sample, e.shadow >= 0 ? "shadow ray" : "ray",
                            std::max(e.node, e.shadow));
    return text;
}

int samplesToDiagnose(const Settings& settings) { return std::min(settings.spp, 64); }

std::vector<Diagnosis> diagnosePixel(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                                     const std::function<void()>& beforeSample, const std::stop_token& stop) {
    const PixelEvidence pixel = gatherEvidence(world, seed, x, y, samples, beforeSample, stop);
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
