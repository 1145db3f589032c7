// Rays at shared edges and vertices: nothing may slip through, nothing may be hit twice.
#include <algorithm>
#include <cmath>

#include "bvh/intersect/hit_error.h"
#include "measure/lab/controls.h"
#include "measure/lab/exact_crossing.h"
#include "measure/lab/random.h"
#include "measure/lab/test_point.h"

namespace rayscope::measure {

namespace {

/// The triangles around an edge or a vertex, and a point there.
struct SharedFeature {
    std::span<const std::uint32_t> triangles;
    std::uint32_t ends[2];  ///< the vertices of the edge, or the vertex twice
    glm::dvec3 point;
};

SharedFeature randomSharedFeature(const LabContext& target, LabRandom& random) {
    const auto& edges = target.mesh.edges();
    const auto& closed = target.mesh.closedVertices();
    if (!closed.empty() && random.coin()) {
        const std::uint32_t vertex = closed[random.below(closed.size())];
        return {target.mesh.trianglesAround(vertex), {vertex, vertex}, target.vertices[vertex]};
    }
    const SharedEdge& edge = edges[random.below(edges.size())];
    const glm::dvec3 a = target.vertices[edge.a], b = target.vertices[edge.b];
    return {edge.triangles, {edge.a, edge.b}, a + static_cast<double>(random.below(257)) / 256.0 * (b - a)};
}

/// From all around, from close by, from far away, and along an axis with zeros of either sign.
Ray rayAt(const LabContext& target, const glm::dvec3& point, LabRandom& random) {
    const double kind = random.real();
    Ray ray;
    if (kind < 0.2) {
        const auto axis = static_cast<int>(random.below(3));
        const double sign = random.coin() ? 1.0 : -1.0;
        ray.origin = glm::vec3(point);
        ray.origin[axis] = static_cast<float>(point[axis] - sign * target.size * random.real(0.01, 2.0));
        ray.direction = glm::vec3(random.coin() ? 0.0f : -0.0f);
        ray.direction[axis] = static_cast<float>(sign);
        return ray;
    }
    const double distance = kind < 0.4   ? std::pow(10.0, random.real(-5.0, -1.0))
                            : kind < 0.5 ? std::pow(10.0, random.real(0.5, 3.0))
                                         : random.real(0.1, 3.0);
    const glm::dvec3 from = kind < 0.4 ? point : target.center;
    ray.origin = glm::vec3(from + distance * target.size * random.onSphere());
    glm::dvec3 direction = point - glm::dvec3(ray.origin);
    if (random.coin()) direction = glm::normalize(direction);
    ray.direction = glm::vec3(direction);
    return ray;
}

/// What exact arithmetic says about a ray and the triangles around a seam.
struct ExactResult {
    std::vector<ExactCrossing> crossings;
    bool odd = false;       ///< crosses them an odd number of times
    bool clear = true;      ///< passes their rim at a distance that rounding cannot bridge
    bool inFront = true;    ///< all crossings lie before the ray's origin
    double farthest = 0.0;  ///< t of the last crossing and what it may be off by

    ExactResult(const LabContext& target, const SharedFeature& seam, const Ray& ray) {
        const bvh::ShearedRay sheared(bvh::rayData(ray));
        for (const std::uint32_t triangle : seam.triangles) {
            const glm::vec3 a = target.corner(triangle, 0), b = target.corner(triangle, 1),
                            c = target.corner(triangle, 2);
            const ExactCrossing& exact = crossings.emplace_back(ray, a, b, c);
            const bvh::HitError error(sheared, a, b, c);
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t corner = target.mesh.triangles()[triangle][k];
                const bool onRim = corner == seam.ends[0] || corner == seam.ends[1];
                if (onRim && std::abs(exact.edges[k]) <= 2.0L * static_cast<long double>(error.edge))
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

/// Counts what a triangle test finds around the seam, and how accurately.
template <class Test>
void checkControl(const LabContext& target, const SharedFeature& seam, const ExactResult& truth,
                  const Ray& ray, LabMethod method, const Test& test, LabTally& tally) {
    using Vector = typename Test::Vector;
    LabCounts& counts = tally.of(method);
    ++counts.sharedEdgeRays;
    int hits = 0;
    for (std::size_t i = 0; i < seam.triangles.size(); ++i) {
        const glm::vec3 a = target.corner(seam.triangles[i], 0), b = target.corner(seam.triangles[i], 1),
                        c = target.corner(seam.triangles[i], 2);
        typename Test::Found found;
        if (!test(Vector(ray.origin), Vector(ray.direction), a, b, c, found)) continue;
        ++hits;
        const ExactCrossing& exact = truth.crossings[i];
        if (!exact.crossed) continue;
        const bvh::HitError error(bvh::ShearedRay(bvh::rayData(ray)), a, b, c);
        const auto off = [](auto value, long double right) {
            return static_cast<double>(std::abs(static_cast<long double>(value) - right));
        };
        counts.tRatio =
            std::max(counts.tRatio, off(found.t, exact.t) / error.ofHitT(static_cast<double>(exact.t)));
        counts.weightRatio = std::max(
            {counts.weightRatio, off(found.u, exact.u) / error.ofHitWeight(static_cast<double>(exact.u)),
             off(found.v, exact.v) / error.ofHitWeight(static_cast<double>(exact.v))});
    }
    if (hits == 0) {
        ++counts.leaks;
        tally.fail(method, LabFailureKind::Leak, ray);
    } else if (hits % 2 == 0) {
        ++counts.doubleHits;
        tally.fail(method, LabFailureKind::DoubleHit, ray);
    }
}

void checkTracer(const LabContext& target, const SharedFeature& seam, const ExactResult& truth,
                 const Ray& ray, LabTally& tally) {
    LabCounts& counts = tally.of(LabMethod::Rayscope);
    ++counts.sharedEdgeRays;
    Hit hit;
    const bool found = target.world.closestHit(ray, 0.0f, hit);
    if (!found || static_cast<double>(hit.t) > truth.farthest) {
        ++counts.leaks;
        tally.fail(LabMethod::Rayscope, LabFailureKind::Leak, ray);
    }
    const bvh::ShearedRay sheared(bvh::rayData(ray));
    int hits = 0;
    for (const std::uint32_t triangle : seam.triangles) {
        bvh::TriangleHit single;
        hits += bvh::intersectTriangle(sheared, target.corner(triangle, 0), target.corner(triangle, 1),
                                       target.corner(triangle, 2), single);
    }
    if (hits % 2 == 0) {
        ++counts.doubleHits;
        tally.fail(LabMethod::Rayscope, LabFailureKind::DoubleHit, ray);
    }
    if (found) checkHit(target, ray, hit, tally);
}

}  // namespace

void testWatertightness(const LabContext& target, std::uint64_t index, LabTally& tally) {
    if (target.mesh.edges().empty()) return;
    LabRandom random(target.seed, index);
    const SharedFeature seam = randomSharedFeature(target, random);
    const Ray ray = rayAt(target, seam.point, random);
    if (ray.direction == glm::vec3(0.0f)) return;
    const ExactResult truth(target, seam, ray);
    if (!truth.clear) ++tally.undecided;
    if (!truth.clear || !truth.odd || !truth.inFront) return;
    checkTracer(target, seam, truth, ray, tally);
    checkControl(target, seam, truth, ray, LabMethod::Float, kFloatControl, tally);
    checkControl(target, seam, truth, ray, LabMethod::Epsilon, kEpsilonControl, tally);
    checkControl(target, seam, truth, ray, LabMethod::Double, kDoubleControl, tally);
}

void checkHit(const LabContext& target, const Ray& ray, const Hit& hit, LabTally& tally) {
    LabCounts& counts = tally.of(LabMethod::Rayscope);
    const glm::vec3 a = target.corner(hit.primitive, 0), b = target.corner(hit.primitive, 1),
                    c = target.corner(hit.primitive, 2);
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
    if (exact.parallel) return;  // seen edge-on to within the error: t may be anything between its corners
    const auto ratio = [](float value, long double truth, double bound) {
        return static_cast<double>(std::abs(static_cast<long double>(value) - truth)) / bound;
    };
    const double t = ratio(hit.t, exact.t, error.ofHitT(static_cast<double>(exact.t)));
    const double weight = std::max(ratio(hit.u, exact.u, error.ofHitWeight(static_cast<double>(exact.u))),
                                   ratio(hit.v, exact.v, error.ofHitWeight(static_cast<double>(exact.v))));
    counts.tRatio = std::max(counts.tRatio, t);
    counts.weightRatio = std::max(counts.weightRatio, weight);
    if (t > 1.0 || weight > 1.0) tally.fail(LabMethod::Rayscope, LabFailureKind::Inaccurate, ray);
}

}  // namespace rayscope::measure
