// Noisy and slow pixels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/vectors.h"
#include "probe/diagnosis_parts.h"
#include "probe/sample_cost.h"
#include "render/film.h"

namespace rayscope::probe {

namespace {

/// The reflections between the pixel and a surface.
enum PathType { kDirect, kMirrored, kGlossy, kPathTypes };

PathType pathTypeOf(const RayTree& tree, int node) {
    PathType type = kDirect;
    for (; node >= 0; node = tree.nodes[static_cast<std::size_t>(node)].parent) {
        const RayKind kind = tree.nodes[static_cast<std::size_t>(node)].kind;
        if (kind == RayKind::Glossy) return kGlossy;
        if (kind == RayKind::Reflection) type = kMirrored;
    }
    return type;
}

double variance(const std::vector<double>& values) {
    double mean = 0.0, squares = 0.0;
    for (const double x : values) mean += x / static_cast<double>(values.size());
    for (const double x : values) squares += (x - mean) * (x - mean);
    return values.size() < 2 ? 0.0 : squares / static_cast<double>(values.size() - 1);
}

/// Whether a hit is far from the tangent plane of another of the same pixel, for instance on both sides of a
/// silhouette of one object.
bool isBesideSurface(const RayNode& surface, const RayNode& other) {
    constexpr double kSteep = 10.0, kRounding = 1e-4;
    const glm::dvec3 between = glm::dvec3(other.position) - glm::dvec3(surface.position);
    const glm::dvec3 along = glm::normalize(glm::dvec3(surface.ray.direction));
    const double across = glm::length(glm::cross(along, between));
    const double distance = math::distance(surface.ray.origin, surface.position);
    return std::abs(glm::dot(between, glm::dvec3(surface.geometricNormal))) >
           kSteep * across + kRounding * distance;
}

/// Whether camera rays of the pixel hit different surfaces: objects, materials, or parts of one object;
/// `evidence` gets a sample of each.
bool seesDifferentSurfaces(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    const auto nodeOf = [&](std::size_t sample) -> const RayNode& {
        return pixel.trees[sample].nodes.front();
    };
    const auto isSame = [&](const RayNode& a, const RayNode& b) {
        if (!a.hit || !b.hit) return a.hit == b.hit;
        return a.object == b.object && a.material == b.material && !isBesideSurface(a, b);
    };
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample) {
        const bool known = std::any_of(evidence.begin(), evidence.end(), [&](const Evidence& seen) {
            return isSame(nodeOf(static_cast<std::size_t>(seen.sample)), nodeOf(sample));
        });
        if (!known) evidence.push_back({static_cast<int>(sample), 0, -1});
    }
    return evidence.size() > 1;
}

/// Whether some light samples are visible and others occluded; `evidence` gets one of each.
bool isPenumbra(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    int visible = 0, occluded = 0;
    for (std::size_t sample = 0; sample < pixel.trees.size(); ++sample)
        for (std::size_t i = 0; i < pixel.trees[sample].shadowRays.size(); ++i) {
            const Visibility visibility = pixel.trees[sample].shadowRays[i].visibility;
            int& count = visibility == Visibility::Occluded ? occluded : visible;
            if (visibility == Visibility::FacingAway) continue;
            if (count++ == 0) evidence.push_back({static_cast<int>(sample), -1, static_cast<int>(i)});
        }
    return visible > 0 && occluded > 0;
}

/// The pixels of a regular grid of `columns` * `columns` whose first sample hits a surface.
std::vector<glm::ivec2> surfacePixels(const PixelEvidence& pixel, int columns) {
    std::vector<glm::ivec2> pixels;
    for (int i = 0; i < columns * columns; ++i) {
        const glm::ivec2 at((2 * (i % columns) + 1) * pixel.world.width / (2 * columns),
                            (2 * (i / columns) + 1) * pixel.world.height / (2 * columns));
        if (probeSample(pixel.world, pixel.seed, {at.x, at.y, 0}).nodes.front().hit) pixels.push_back(at);
    }
    return pixels;
}

/// Medians of the first samples of pixels that see a surface; nothing if no such pixels are found.
std::optional<SampleCost> medianCosts(const PixelEvidence& pixel) {
    constexpr std::size_t kEnough = 16;
    std::vector<glm::ivec2> pixels;
    for (int columns = 7; columns <= 28 && pixels.size() < kEnough; columns *= 2)
        pixels = surfacePixels(pixel, columns);
    if (pixels.empty()) return std::nullopt;
    std::vector<double> nodes, tests, rays;
    for (const glm::ivec2 at : pixels) {
        const SampleCost cost = costAt(pixel.world, pixel.seed, at.x, at.y, 1);
        nodes.push_back(cost.nodes);
        tests.push_back(cost.tests);
        rays.push_back(cost.rays);
    }
    const auto median = [](std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    };
    return SampleCost{.nodes = median(nodes), .tests = median(tests), .rays = median(rays)};
}

/// A duplicate surface along some ray of the first samples.
std::uint32_t findDuplicate(const PixelEvidence& pixel, std::vector<Evidence>& evidence) {
    constexpr int kMaxSamples = 4;
    for (int sample = 0; sample < std::min(kMaxSamples, static_cast<int>(pixel.trees.size())); ++sample) {
        const RayTree& tree = pixel.trees[static_cast<std::size_t>(sample)];
        const auto searchAlong = [&](const Ray& ray, Evidence where) {
            const std::uint32_t found = findDuplicateAlong(pixel.world, ray, tree.time);
            if (found != kNoPrimitive) evidence = {where};
            return found;
        };
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            if (const auto found = searchAlong(tree.nodes[i].ray, {sample, static_cast<int>(i), -1});
                found != kNoPrimitive)
                return found;
        for (std::size_t i = 0; i < tree.shadowRays.size(); ++i)
            if (const auto found = searchAlong(tree.shadowRays[i].ray, {sample, -1, static_cast<int>(i)});
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
    const std::string howMuch = fmt::format("The standard error of the mean is {:.0f} %",
                                            100.0 * s.errorOfMean() / std::max(s.mean, 1e-12));

    std::vector<double> byType[kPathTypes];
    for (const RayTree& tree : pixel.trees) {
        double sums[kPathTypes] = {};
        for (std::size_t i = 0; i < tree.nodes.size(); ++i)
            sums[pathTypeOf(tree, static_cast<int>(i))] += math::luminance(tree.nodes[i].contribution);
        for (int type = 0; type < kPathTypes; ++type) byType[type].push_back(sums[type]);
    }
    double highestVariance = 0.0;
    int noisiest = kDirect;
    for (int type = 0; type < kPathTypes; ++type)
        if (variance(byType[type]) > highestVariance) {
            highestVariance = variance(byType[type]);
            noisiest = type;
        }
    double fraction = 0.0;  // of the radiance, by outliers
    for (const std::size_t i : s.outliers)
        fraction += s.luminance[i] / (s.mean * static_cast<double>(s.luminance.size()));
    const bool rare = !s.outliers.empty() && 4 * s.outliers.size() <= s.luminance.size() && fraction > 0.5;
    if (noisiest == kGlossy) {
        why.cause = rare ? Cause::RareBrightPaths : Cause::GlossyReflection;
        why.sentence = rare ? fmt::format(
                                  "{}: {} of {} samples contribute {:.0f} % of the radiance, by glossy "
                                  "reflections that rarely hit something bright.",
                                  howMuch, s.outliers.size(), s.luminance.size(), 100.0 * fraction)
                            : howMuch + ": glossy rays of different samples hit different surfaces.";
        for (const std::size_t i : s.outliers) why.evidence.push_back({static_cast<int>(i), 0, -1});
        return why;
    }
    if (seesDifferentSurfaces(pixel, why.evidence)) {
        why.cause = Cause::Edge;
        why.sentence =
            howMuch + (pixel.world.camera.hasLens() ? ": because of the lens, samples hit different surfaces."
                                                    : ": samples of the pixel hit different surfaces.");
        return why;
    }
    why.evidence.clear();
    if (isPenumbra(pixel, why.evidence)) {
        why.cause = Cause::Penumbra;
        why.sentence = howMuch + ": the light is visible to some samples and occluded for others.";
        return why;
    }
    why.sentence = howMuch + "; its rays show no cause.";
    return why;
}

std::optional<Diagnosis> diagnoseSlow(const PixelEvidence& pixel) {
    constexpr double kSlow = 4.0;
    const SampleId name = pixel.trees.empty() ? SampleId{} : pixel.trees.front().name;
    const SampleCost cost =
        costAt(pixel.world, pixel.seed, name.x, name.y, static_cast<int>(pixel.trees.size()));
    const std::optional<SampleCost> medians = medianCosts(pixel);
    if (!medians) return std::nullopt;
    const SampleCost& median = *medians;
    if (!(cost.nodes > kSlow * std::max(median.nodes, 10.0) ||
          cost.tests > kSlow * std::max(median.tests, 10.0)))
        return std::nullopt;
    Diagnosis why{Symptom::Slow, Cause::Unknown, "", {{0, 0, -1}}};
    const double perRay = cost.nodes / std::max(cost.rays, 1.0),
                 medianPerRay = median.nodes / std::max(median.rays, 1.0);
    const std::string howMuch = fmt::format(
        "A sample visits {:.0f} BVH nodes and tests {:.0f} primitives (median of the pixels that see a "
        "surface: "
        "{:.0f} and {:.0f})",
        cost.nodes, cost.tests, median.nodes, median.tests);
    if (const auto duplicate = findDuplicate(pixel, why.evidence); duplicate != kNoPrimitive) {
        why.cause = Cause::DuplicateGeometry;
        why.sentence = fmt::format("{}: another primitive coincides with {}.", howMuch,
                                   locationText(pixel.world, duplicate));
        return why;
    }
    const bool many = cost.rays / std::max(median.rays, 1.0) > perRay / std::max(medianPerRay, 1e-9);
    why.cause = many ? Cause::ManyRays : Cause::ExpensiveRays;
    why.sentence =
        many ? fmt::format("{}: it traces {:.0f} rays instead of {:.0f}.", howMuch, cost.rays, median.rays)
             : fmt::format("{}: a ray visits {:.0f} nodes instead of {:.0f}.", howMuch, perRay, medianPerRay);
    return why;
}

}  // namespace rayscope::probe
