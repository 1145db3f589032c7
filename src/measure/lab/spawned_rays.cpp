// Spawned rays: they must not hit the surface they start on, nor miss a surface just above it.
#include <algorithm>
#include <cmath>

#include "bvh/intersect/hit_error.h"
#include "bvh/intersect/ray_query.h"
#include "math/spawn.h"
#include "measure/lab/controls.h"
#include "measure/lab/exact_sum.h"
#include "measure/lab/test_point.h"
#include "measure/lab/test_rays.h"
#include "trace/interaction.h"

namespace rayscope::measure {

namespace {

struct Corners {
    glm::vec3 a, b, c;
};

Corners cornersOf(const LabContext& context, std::uint32_t triangle) {
    return {context.corner(triangle, 0), context.corner(triangle, 1), context.corner(triangle, 2)};
}

/// The exact sign of direction · normal.
int sideOf(const Corners& t, const glm::vec3& direction) {
    ExactSum sum;
    addDeterminant(sum, t.b, t.c, direction);
    addDeterminant(sum, -t.a, t.c, direction);
    addDeterminant(sum, t.b, -t.a, direction);
    return sum.sign();
}

int sideOfPoint(const Corners& t, const glm::vec3& point) {
    return signedVolume(t.a, t.b, t.c, point).sign();
}

/// The hit point as the control computes it.
template <class Test>
bool controlPoint(const Test& test, const Ray& ray, const Corners& t, typename Test::Vector& point) {
    typename Test::Hit found;
    if (!test(typename Test::Vector(ray.origin), typename Test::Vector(ray.direction), t.a, t.b, t.c, found))
        return false;
    point = typename Test::Vector(ray.origin) + found.t * typename Test::Vector(ray.direction);
    return true;
}

/// A second surface: the triangle translated along its normal, at least eight error bounds away after
/// rounding.
struct OffsetSurface {
    Corners corners{};
    glm::vec3 towards{0.0f};
    bool isWide = false;  ///< so much wider than the distance that a ray along the normal must hit it

    OffsetSurface(const Corners& t, const trace::Interaction& at, const glm::dvec3& normal) {
        const glm::dvec3 a = t.a, b = t.b, c = t.c;
        double bound = math::spawnDistance(at.position, at.magnitude, normal);
        for (const glm::dvec3& p : {a, b, c})
            bound = std::max(bound, math::spawnDistance(p, at.magnitude, normal));
        const glm::dvec3 step = 9.0 * bound * normal;
        corners = {glm::vec3(a + step), glm::vec3(b + step), glm::vec3(c + step)};
        towards = glm::vec3(normal);
        const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
        const double height = glm::length(glm::cross(b - a, c - a)) / longest;
        const double u = static_cast<double>(at.hit.u), v = static_cast<double>(at.hit.v);
        isWide = std::min({u, v, 1.0 - u - v}) > 0.1 && height > 100.0 * bound;
    }
};

template <class Test>
void checkControl(const Corners& t, const Ray& first, const glm::vec3& direction,
                  const OffsetSurface& offsetSurface, LabMethod method, const Test& test, LabTally& tally) {
    using Vector = typename Test::Vector;
    Vector point;
    if (!controlPoint(test, first, t, point)) return;
    LabCounts& counts = tally.of(method);
    ++counts.spawned;
    typename Test::Hit found;
    if (test(point, Vector(direction), t.a, t.b, t.c, found)) {
        ++counts.falseHits;
        tally.fail(method, LabFailureKind::FalseHit, {glm::vec3(point), direction});
    }
    if (!offsetSurface.isWide) return;
    ++counts.offsetSurfaceRays;
    if (test(point, Vector(offsetSurface.towards), offsetSurface.corners.a, offsetSurface.corners.b,
             offsetSurface.corners.c, found))
        return;
    ++counts.missedSurfaces;
    tally.fail(method, LabFailureKind::LostSurface, {glm::vec3(point), offsetSurface.towards});
}

void checkTracer(const LabContext& context, const Corners& t, const Ray& next,
                 const OffsetSurface& offsetSurface, int side, LabTally& tally) {
    LabCounts& counts = tally.of(LabMethod::Rayscope);
    ++counts.spawned;
    // The ray must start on the side that it points to, and can only hit triangles with a vertex on that
    // side.
    bool isFalse = sideOfPoint(t, next.origin) != side;
    Hit hit;
    if (context.world.closestHit(next, 0.0f, hit)) {
        checkHit(context, next, hit, tally);
        const Corners other = cornersOf(context, hit.primitive);
        isFalse |= sideOfPoint(t, other.a) != side && sideOfPoint(t, other.b) != side &&
                   sideOfPoint(t, other.c) != side;
    }
    if (isFalse) {
        ++counts.falseHits;
        tally.fail(LabMethod::Rayscope, LabFailureKind::FalseHit, next);
    }
    if (!offsetSurface.isWide) return;
    ++counts.offsetSurfaceRays;
    const Ray up{next.origin, offsetSurface.towards};
    const bvh::RayQuery query(up);
    if (query.hits(offsetSurface.corners.a, offsetSurface.corners.b, offsetSurface.corners.c, up.tMax, hit))
        return;
    ++counts.missedSurfaces;
    tally.fail(LabMethod::Rayscope, LabFailureKind::LostSurface, up);
}

}  // namespace

void testSpawnedRay(const LabContext& context, std::uint64_t index, LabTally& tally) {
    LabRandom random(context.seed, index);
    const auto triangle = static_cast<std::uint32_t>(random.below(context.mesh.triangles().size()));
    const Ray first = rayAtTriangle(context, triangle, random);
    Hit hit;
    if (first.direction == glm::vec3(0.0f) || !context.world.closestHit(first, 0.0f, hit)) return;
    checkHit(context, first, hit, tally);
    const Corners t = cornersOf(context, hit.primitive);
    const trace::Interaction at = trace::interactionAt(context.world, first, 0.0f, {}, hit);
    const bool through = random.coin();
    const glm::dvec3 normal = through ? -at.geometricNormal : at.geometricNormal;
    const glm::vec3 direction = directionAbove(normal, random);
    // Rounding may turn a grazing direction below the plane; such rays are not tested.
    const int side = sideOf(t, direction);
    if (side == 0 || side != -sideOf(t, glm::vec3(-normal))) return;
    const OffsetSurface offsetSurface(t, at, normal);
    checkTracer(context, t, {through ? at.originBehind() : at.originOutside(), direction}, offsetSurface,
                side, tally);
    checkControl(t, first, direction, offsetSurface, LabMethod::Float, kFloatControl, tally);
    checkControl(t, first, direction, offsetSurface, LabMethod::Epsilon, kEpsilonControl, tally);
    checkControl(t, first, direction, offsetSurface, LabMethod::Double, kDoubleControl, tally);
}

}  // namespace rayscope::measure
