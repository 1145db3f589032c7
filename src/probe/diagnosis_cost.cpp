// Noisy and slow pixels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/vectors.h"
#include "probe/aov.h"
#include "probe/diagnosis_parts.h"
#include "render/film.h"

namespace rayscope::probe {

namespace {

/// By which way light came into the pixel.
enum Way { kDirect, kMirrored, kGlossy, kWays };

Way wayOf(const RayTree& tree, int node) {
    Way way = kDirect;
    for (; node >= 0; node = tree.nodes[static_cast<std::size_t>(node)].parent) {
        const RayKind kind = tree.nodes[static_cast<std::size_t>(node)].kind;
        if (kind == RayKind::Glossy) return kGlossy;
        if (kind == RayKind::Reflection) way = kMirrored;
    }
    return way;
}

double variance(const std::vector<double>& values) {
    double mean = 0.0, squares = 0.0;
    for (const double x : values) mean += x / static_cast<double>(values.size());
    for (const double x : values) squares += (x - mean) * (x - mean);
    return values.size() < 2 ? 0.0 : squares / static_cast<double>(values.size() - 1);
}

/// Whether samples of one pixel see different objects, and samples that do.
bool seesDifferentSurfaces(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    std::set<int> objects;
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample) {
        const RayNode& node = pixel.trees[sample].nodes.front();
        if (objects.insert(node.hit ? node.object * 4096 + node.material : -1).second)
            evidence.push_back({static_cast<int>(sample), 0, -1});
    }
    return objects.size() > 1;
}

/// Whether some samples see a light and others do not.
bool isPenumbra(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    int seen = 0, blocked = 0;
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample)
        for (std::size_t i = 0; i < pixel.trees[sample].shadowRays.size(); ++i) {
            const Visibility verdict = pixel.trees[sample].shadowRays[i].visibility;
            int& count = verdict == Visibility::Occluded ? blocked : seen;
            if (verdict == Visibility::FacingAway) continue;
            if (count++ == 0) evidence.push_back({static_cast<int>(sample), -1, static_cast<int>(i)});
        }
    return seen > 0 && blocked > 0;
}

struct Typical {
    double nodes, tests, rays;
};
/// Medians over places all over the picture, of its first sample each.
Typical typicalCosts(const PixelEvidence& pixel) {
    constexpr int kPlaces = 7;
    const trace::World& world = pixel.world;
    std::vector<double> nodes, tests, rays;
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
        const int x = (2 * (i % kPlaces) + 1) * world.width / (2 * kPlaces),
                  y = (2 * (i / kPlaces) + 1) * world.height / (2 * kPlaces);
        const SampleCost cost = costAt(world, pixel.seed, x, y, 1);
        nodes.push_back(cost.nodes);
        tests.push_back(cost.tests);
        rays.push_back(cost.rays);
    }
    const auto median = [](std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    };
    return {median(nodes), median(tests), median(rays)};
}

/// A surface that is there twice, on the way of some ray of the first samples.
std::uint32_t findDuplicate(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    constexpr int kMaxSamples = 4;
    for (int sample = 0; sample < std::min(kMaxSamples, static_cast<int>(pixel.trees.size())); ++sample) {
        const RayTree& tree = pixel.trees[static_cast<std::size_t>(sample)];
        const auto look = [&](const Ray& ray, Evidence where) {
            const std::uint32_t found = findDuplicateAlong(pixel.world, ray, tree.time);
            if (found != kNoPrimitive) evidence = {where};
            return found;
        };
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            if (const auto found = look(tree.nodes[i].ray, {sample, static_cast<int>(i), -1});
                found != kNoPrimitive)
                return found;
        for (std::size_t i = 0; i < tree.shadowRays.size(); ++i)
            if (const auto found = look(tree.shadowRays[i].ray, {sample, -1, static_cast<int>(i)});
                found != kNoPrimitive)
                return found;
    }
    return kNoPrimitive;
}

}  // namespace

std::optional<Diagnosis> diagnoseNoisy(const PixelEvidence& pixel) {
    constexpr double kNoisy = 0.03;  // of the mean, as its standard error
    const SampleStatistics& s = pixel.statistics;
    if (s.luminance.size() < 4 || !(s.errorOfMean() > kNoisy * std::max(s.mean, 1e-3))) return std::nullopt;
    Diagnosis why{Symptom::Noisy, Cause::Unknown, "", {}};
    const std::string howMuch =
        fmt::format("The mean is uncertain by {:.0f} %", 100.0 * s.errorOfMean() / std::max(s.mean, 1e-12));

    std::vector<double> byWay[kWays];
    for (const RayTree& tree : pixel.trees) {
        double sums[kWays] = {};
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            sums[wayOf(tree, static_cast<int>(i))] += math::luminance(tree.nodes[i].contribution);
        for (int way = 0; way < kWays; ++way) byWay[way].push_back(sums[way]);
    }
    double most = 0.0;
    int worst = kDirect;
    for (int way = 0; way < kWays; ++way)
        if (variance(byWay[way]) > most) {
            most = variance(byWay[way]);
            worst = way;
        }
    double brought = 0.0;
    for (const std::size_t i : s.outliers)
        brought += s.luminance[i] / (s.mean * static_cast<double>(s.luminance.size()));
    const bool rare = !s.outliers.empty() && 4 * s.outliers.size() <= s.luminance.size() && brought > 0.5;
    if (worst == kGlossy) {
        why.cause = rare ? Cause::RareBrightPaths : Cause::GlossyReflection;
        why.sentence = rare ? fmt::format(
                                  "{}: {} of {} samples bring {:.0f} % of the light, by glossy reflections "
                                  "that rarely find something bright.",
                                  howMuch, s.outliers.size(), s.luminance.size(), 100.0 * brought)
                            : howMuch + ": glossy rays of different samples see different things.";
        for (const std::size_t i : s.outliers) why.evidence.push_back({static_cast<int>(i), 0, -1});
        return why;
    }
    if (seesDifferentSurfaces(pixel, why.evidence)) {
        why.cause = Cause::Edge;
        why.sentence =
            howMuch + (pixel.world.camera.hasLens() ? ": through the lens, samples meet different surfaces."
                                                    : ": samples of the pixel meet different surfaces.");
        return why;
    }
    why.evidence.clear();
    if (isPenumbra(pixel, why.evidence)) {
        why.cause = Cause::Penumbra;
        why.sentence = howMuch + ": some samples see the light, for others it is blocked.";
        return why;
    }
    why.sentence = howMuch + ", and its rays do not tell why.";
    return why;
}

std::optional<Diagnosis> diagnoseSlow(const PixelEvidence& pixel) {
    constexpr double kSlow = 4.0;
    const SampleId name = pixel.trees.empty() ? SampleId{} : pixel.trees.front().name;
    const auto [nodes, tests, rays] =
        costAt(pixel.world, pixel.seed, name.x, name.y, static_cast<int>(pixel.trees.size()));
    const Typical typical = typicalCosts(pixel);
    if (!(nodes > kSlow * std::max(typical.nodes, 10.0) || tests > kSlow * std::max(typical.tests, 10.0)))
        return std::nullopt;
    Diagnosis why{Symptom::Slow, Cause::Unknown, "", {{0, 0, -1}}};
    const double perRay = nodes / std::max(rays, 1.0),
                 typicalPerRay = typical.nodes / std::max(typical.rays, 1.0);
    const std::string howMuch = fmt::format(
        "A sample enters {:.0f} boxes and tests {:.0f} surfaces, the middle of all pixels {:.0f} and {:.0f}",
        nodes, tests, typical.nodes, typical.tests);
    if (const auto duplicate = findDuplicate(pixel, why.evidence); duplicate != kNoPrimitive) {
        why.cause = Cause::DuplicateGeometry;
        why.sentence = fmt::format("{}: another surface lies exactly where {} is.", howMuch,
                                   locationText(pixel.world, duplicate));
        return why;
    }
    const bool many = rays / std::max(typical.rays, 1.0) > perRay / std::max(typicalPerRay, 1e-9);
    why.cause = many ? Cause::ManyRays : Cause::ExpensiveRays;
    why.sentence =
        many ? fmt::format("{}: it sends {:.0f} rays instead of {:.0f}.", howMuch, rays, typical.rays)
             : fmt::format("{}: each ray searches {:.0f} boxes instead of {:.0f}.", howMuch, perRay,
                           typicalPerRay);
    return why;
}

}  // namespace rayscope::probe
