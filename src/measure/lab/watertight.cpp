// Rays at shared edges and vertices: no leaks and no double hits.
#include <algorithm>
#include <cmath>

#include "bvh/intersect/hit_error.h"
#include "measure/lab/controls.h"
#include "measure/lab/exact_crossing.h"
#include "measure/lab/test_point.h"
#include "measure/lab/test_rays.h"

namespace rayscope::measure {

namespace {

/// The exact crossings of a ray with the triangles around a shared edge or vertex.
struct ExactResult {
    std::vector<ExactCrossing> crossings;
    bool odd = false;       ///< an odd number of crossings
    bool clear = true;      ///< passes their outer boundary by more than the rounding error
    bool inFront = true;    ///< all crossings have t > 0, beyond its error
    double farthest = 0.0;  ///< largest t of the crossings, plus its error bound

    ExactResult(const LabContext& context, const SharedFeature& feature, const Ray& ray) {
        const bvh::ShearedRay sheared(bvh::rayData(ray));
        for (const std::uint32_t triangle : feature.triangles) {
            const glm::vec3 a = context.corner(triangle, 0), b = context.corner(triangle, 1),
                            c = context.corner(triangle, 2);
            const ExactCrossing& exact = crossings.emplace_back(ray, a, b, c);
            const bvh::HitError error(sheared, a, b, c);
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t corner = context.mesh.triangles()[triangle][k];
                const bool onBoundary = corner == feature.ends[0] || corner == feature.ends[1];
                if (onBoundary && std::abs(exact.edges[k]) <= 2.0L * static_cast<long double>(error.edge))
                    clear = false;
            }
            if (!exact.crossed) continue;
            odd = !odd;
            const auto t = static_cast<double>(exact.t);
            farthest = std::max(farthest, t + error.ofHitT(t));
            if (!(t - error.ofHitT(t) > 0.0) || !(farthest < 1e37)) inFront = false;
        }
    }
};

/// Counts the hits of a control around the feature, and their errors.
template <class Test>
void checkControl(const LabContext& context, const SharedFeature& feature, const ExactResult& exact,
                  const Ray& ray, LabMethod method, const Test& test, LabTally& tally) {
    using Vector = typename Test::Vector;
    LabCounts& counts = tally.of(method);
    ++counts.sharedEdgeRays;
    int hits = 0;
    for (std::size_t i = 0; i < feature.triangles.size(); ++i) {
        const glm::vec3 a = context.corner(feature.triangles[i], 0),
                        b = context.corner(feature.triangles[i], 1),
                        c = context.corner(feature.triangles[i], 2);
        typename Test::Hit found;
        if (!test(Vector(ray.origin), Vector(ray.direction), a, b, c, found)) continue;
        ++hits;
        const ExactCrossing& crossing = exact.crossings[i];
        if (!crossing.crossed) continue;
        const bvh::HitError error(bvh::ShearedRay(bvh::rayData(ray)), a, b, c);
        const auto off = [](auto value, long double right) {
            return static_cast<double>(std::abs(static_cast<long double>(value) - right));
        };
        counts.tRatio =
            std::max(counts.tRatio, off(found.t, crossing.t) / error.ofHitT(static_cast<double>(crossing.t)));
        counts.weightRatio =
            std::max({counts.weightRatio,
                      off(found.u, crossing.u) / error.ofHitWeight(static_cast<double>(crossing.u)),
                      off(found.v, crossing.v) / error.ofHitWeight(static_cast<double>(crossing.v))});
    }
    if (hits == 0) {
        ++counts.leaks;
        tally.fail(method, LabFailureKind::Leak, ray);
    } else if (hits % 2 == 0) {
        ++counts.doubleHits;
        tally.fail(method, LabFailureKind::DoubleHit, ray);
    }
}

void checkTracer(const LabContext& context, const SharedFeature& feature, const ExactResult& exact,
                 const Ray& ray, LabTally& tally) {
    LabCounts& counts = tally.of(LabMethod::Rayscope);
    ++counts.sharedEdgeRays;
    Hit hit;
    const bool found = context.world.closestHit(ray, 0.0f, hit);
    if (!found || static_cast<double>(hit.t) > exact.farthest) {
        ++counts.leaks;
        tally.fail(LabMethod::Rayscope, LabFailureKind::Leak, ray);
    }
    const bvh::ShearedRay sheared(bvh::rayData(ray));
    int hits = 0;
    for (const std::uint32_t triangle : feature.triangles) {
        bvh::TriangleHit single;
        hits += bvh::intersectTriangle(sheared, context.corner(triangle, 0), context.corner(triangle, 1),
                                       context.corner(triangle, 2), single);
    }
    if (hits % 2 == 0) {
        ++counts.doubleHits;
        tally.fail(LabMethod::Rayscope, LabFailureKind::DoubleHit, ray);
    }
    if (found) checkHit(context, ray, hit, tally);
}

}  // namespace

void testWatertightness(const LabContext& context, std::uint64_t index, LabTally& tally) {
    if (context.mesh.edges().empty()) return;
    LabRandom random(context.seed, index);
    const SharedFeature feature = randomSharedFeature(context, random);
    const Ray ray = rayAtPoint(context, feature.point, random);
    if (ray.direction == glm::vec3(0.0f)) return;
    const ExactResult exact(context, feature, ray);
    if (!exact.clear) ++tally.undecided;
    if (!exact.clear || !exact.odd || !exact.inFront) return;
    checkTracer(context, feature, exact, ray, tally);
    checkControl(context, feature, exact, ray, LabMethod::Float, kFloatControl, tally);
    checkControl(context, feature, exact, ray, LabMethod::Epsilon, kEpsilonControl, tally);
    checkControl(context, feature, exact, ray, LabMethod::Double, kDoubleControl, tally);
}

void checkHit(const LabContext& context, const Ray& ray, const Hit& hit, LabTally& tally) {
    LabCounts& counts = tally.of(LabMethod::Rayscope);
    const glm::vec3 a = context.corner(hit.primitive, 0), b = context.corner(hit.primitive, 1),
                    c = context.corner(hit.primitive, 2);
    const ExactCrossing exact(ray, a, b, c);
    const bvh::HitError error(bvh::ShearedRay(bvh::rayData(ray)), a, b, c);
    bool left = false, right = false;
    for (const long double edge : exact.edges) {
        left |= edge < -static_cast<long double>(error.edge);
        right |= edge > static_cast<long double>(error.edge);
    }
    if (left && right) {
        ++counts.falseHits;
        tally.fail(LabMethod::Rayscope, LabFailureKind::FalseHit, ray);
        return;
    }
    if (exact.parallel) return;  // edge-on within the error bound: t may be that of any point of the triangle
    const auto ratio = [](float value, long double expected, double bound) {
        return static_cast<double>(std::abs(static_cast<long double>(value) - expected)) / bound;
    };
    const double t = ratio(hit.t, exact.t, error.ofHitT(static_cast<double>(exact.t)));
    const double weight = std::max(ratio(hit.u, exact.u, error.ofHitWeight(static_cast<double>(exact.u))),
                                   ratio(hit.v, exact.v, error.ofHitWeight(static_cast<double>(exact.v))));
    counts.tRatio = std::max(counts.tRatio, t);
    counts.weightRatio = std::max(counts.weightRatio, weight);
    if (t > 1.0 || weight > 1.0) tally.fail(LabMethod::Rayscope, LabFailureKind::Inaccurate, ray);
}

}  // namespace rayscope::measure
