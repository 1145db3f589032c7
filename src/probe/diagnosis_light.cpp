// Black and bright pixels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/vectors.h"
#include "probe/diagnosis_parts.h"
#include "render/film.h"

namespace rayscope::probe {

namespace {

/// Visibility of all light samples at the surfaces that camera rays hit.
struct LightTally {
    int occluded = 0, behind = 0, visible = 0, hits = 0, misses = 0;
    std::vector<Evidence> occludedRays, behindRays, hitRays, missedRays;
};

LightTally tallyOf(const PixelEvidence& pixel) {
    LightTally tally;
    constexpr std::size_t kMaxEvidence = 8;
    const auto keep = [](std::vector<Evidence>& list, Evidence evidence) {
        if (list.size() < kMaxEvidence) list.push_back(evidence);
    };
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample) {
        const RayTree& tree = pixel.trees[sample];
        const int s = static_cast<int>(sample);
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            if (tree.nodes[i].depth > 0) continue;
            ++(tree.nodes[i].hit ? tally.hits : tally.misses);
            keep(tree.nodes[i].hit ? tally.hitRays : tally.missedRays, {s, static_cast<int>(i), -1});
        }
        for (std::size_t i = 0; i < tree.shadowRays.size(); ++i) {
            const ShadowRay& ray = tree.shadowRays[i];
            if (tree.nodes[static_cast<std::size_t>(ray.node)].depth > 0) continue;
            const Evidence evidence{s, -1, static_cast<int>(i)};
            if (ray.visibility == Visibility::Occluded) {
                ++tally.occluded;
                keep(tally.occludedRays, evidence);
            } else if (ray.visibility == Visibility::FacingAway) {
                ++tally.behind;
                keep(tally.behindRays, evidence);
            } else {
                ++tally.visible;
            }
        }
    }
    return tally;
}

std::string occluderOf(const PixelEvidence& pixel, const Evidence& evidence) {
    const RayTree& tree = pixel.trees[static_cast<std::size_t>(evidence.sample)];
    Hit hit;
    if (!pixel.world.closestHit(tree.shadowRays[static_cast<std::size_t>(evidence.shadow)].ray, tree.time,
                                hit))
        return "a surface";
    return locationText(pixel.world, hit.primitive);
}

bool reflectsNothing(const PixelEvidence& pixel, const Evidence& evidence) {
    const RayNode& node =
        pixel.trees[static_cast<std::size_t>(evidence.sample)].nodes[static_cast<std::size_t>(evidence.node)];
    const trace::SurfaceMaterial& material = pixel.world.materials[static_cast<std::size_t>(node.material)];
    return node.kd == Rgb(0.0f) && material.ks == glm::dvec3(0.0);
}

/// The first surface whose vertex normals deviate far from its geometric normal, if any.
std::optional<Diagnosis> badNormal(const PixelEvidence& pixel, const LightTally& tally) {
    constexpr double kFar = 75.0;  // degrees; smooth surfaces stay well below
    for (const Evidence& evidence : tally.hitRays) {
        const RayTree& tree = pixel.trees[static_cast<std::size_t>(evidence.sample)];
        const RayNode& node = tree.nodes[static_cast<std::size_t>(evidence.node)];
        const double angle = normalDeviation(pixel.world, node, tree.time);
        if (angle <= kFar) continue;
        return Diagnosis{Symptom::Black,
                         Cause::BadNormal,
                         fmt::format("A vertex normal of {} deviates by {:.0f} degrees from the geometric "
                                     "normal, so the surface is "
                                     "shaded as if it had another orientation.",
                                     locationText(pixel.world, node.primitiveHit.primitive), angle),
                         {evidence}};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Diagnosis> diagnoseBlack(const PixelEvidence& pixel) {
    constexpr double kBlack = 1e-4;
    if (!(pixel.statistics.mean < kBlack)) return std::nullopt;
    const LightTally tally = tallyOf(pixel);
    if (tally.hits == 0)
        return Diagnosis{Symptom::Black, Cause::NothingHit,
                         "All camera rays miss the scene, and the environment is black or absent there.",
                         tally.missedRays};
    if (pixel.world.lights.empty())
        return Diagnosis{Symptom::Black, Cause::NoLight, "The scene has no light.", tally.hitRays};
    if (std::all_of(tally.hitRays.begin(), tally.hitRays.end(),
                    [&](const Evidence& e) { return reflectsNothing(pixel, e); }))
        return Diagnosis{Symptom::Black, Cause::BlackMaterial,
                         "The material reflects no light: kd and ks are 0.", tally.hitRays};
    if (auto normal = badNormal(pixel, tally)) return normal;
    if (tally.visible == 0 && tally.occluded > 0)
        return Diagnosis{
            Symptom::Black, Cause::LightOccluded,
            fmt::format("{} of {} shadow rays are occluded, the first by {}{}.", tally.occluded,
                        tally.occluded + tally.behind, occluderOf(pixel, tally.occludedRays.front()),
                        tally.behind > 0 ? "; the other lights are behind the surface" : ""),
            tally.occludedRays};
    if (tally.visible == 0 && tally.behind > 0)
        return Diagnosis{Symptom::Black, Cause::LightBehindSurface,
                         "All lights are behind the visible surface.", tally.behindRays};
    return Diagnosis{Symptom::Black, Cause::Unknown,
                     "The pixel is black although light reaches the visible surface.", tally.hitRays};
}

std::optional<Diagnosis> diagnoseBright(const PixelEvidence& pixel) {
    constexpr double kBright = 1.5;
    if (!(pixel.statistics.mean > kBright)) return std::nullopt;
    // By light, including reflections.
    std::vector<double> byLight(pixel.world.lights.size(), 0.0);
    std::vector<Evidence> strongest(byLight.size());
    std::vector<double> most(byLight.size(), -1.0);
    double total = 0.0;
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample) {
        const RayTree& tree = pixel.trees[sample];
        total += math::luminance(tree.radiance);
        for (std::size_t i = 0; i < tree.shadowRays.size(); ++i) {
            const auto light = static_cast<std::size_t>(tree.shadowRays[i].light);
            const double added = math::luminance(tree.shadowRays[i].contribution);
            byLight[light] += added;
            if (added <= most[light]) continue;
            most[light] = added;
            strongest[light] = {static_cast<int>(sample), -1, static_cast<int>(i)};
        }
    }
    const auto best =
        static_cast<std::size_t>(std::max_element(byLight.begin(), byLight.end()) - byLight.begin());
    if (byLight.empty() || byLight[best] < 0.5 * total)
        return Diagnosis{Symptom::Bright,
                         Cause::Unknown,
                         "The radiance exceeds the display range; no single light contributes most of it.",
                         {}};
    return Diagnosis{
        Symptom::Bright,
        Cause::StrongLight,
        fmt::format("Light {} contributes {:.0f} % of a radiance that exceeds the display range.", best,
                    100.0 * byLight[best] / total),
        {strongest[best]}};
}

}  // namespace rayscope::probe
