#pragma once
// Order-independent hit acceptance: a hit depends on the ray and the primitive only, not on the traversal.
#include "bvh/kernel/exact_triangle.h"

namespace rayscope::bvh::kernel {

/// Whether the ray intersects the box between its tMin and `bound`; `entry` is where. See intersect_box.h.
RAYSCOPE_INLINE bool intersectBox(Float4 lower, Float4 upper, const BoxRay& ray, float bound, float& entry) {
    const Float4 near = ((ray.backward ? upper : lower) - ray.origin) * ray.nearInverse;
    const Float4 far = ((ray.backward ? lower : upper) - ray.origin) * ray.farInverse;
    float enter = ray.tMin;
    float leave = bound;
    for (int axis = 0; axis < 3; ++axis) {
        enter = near[axis] > enter ? near[axis] : enter;
        leave = far[axis] < leave ? far[axis] : leave;
    }
    entry = enter;
    return enter <= leave;
}

/// Six planes in the layout of a BinaryNode: lower x, y, z, –, upper x, y, z, –.
using BoxPlanes = const float*;

/// Without the fourth number, which may be denormal as a float and slow.
RAYSCOPE_INLINE Float4 load3(const float* from) {
    return __builtin_bit_cast(Float4, __builtin_bit_cast(Int4, load4(from)) & Int4{-1, -1, -1, 0});
}

RAYSCOPE_INLINE bool intersectBox(BoxPlanes box, const BoxRay& ray, float bound, float& entry) {
    return intersectBox(load3(box), load3(box + 4), ray, bound, entry);
}

/// The layout of a Hit.
struct HitData {
    float t;
    uint32_t primitive;
    float u, v;
};

/// Rounds t, and accepts it if it lies in (tMin, bound] and the ray intersects the primitive's own box. Where
/// t itself has lost digits (an origin very close to a large triangle) it may round to a value before that
/// box; then it is moved to the entry of the box.
RAYSCOPE_INLINE bool acceptHit(const BoxRay& ray, float tMin, double t, Float4 lower, Float4 upper,
                               float bound, float& rounded) {
    rounded = static_cast<float>(t);
    if (!(rounded > tMin && rounded <= bound && rounded < kInfinity)) return false;
    float entry;
    if (!intersectBox(lower, upper, ray, ray.tMax, entry)) return false;
    if (rounded * ray.scale < entry) {
        const double boundary = entry / ray.scale;
        rounded = static_cast<float>(boundary);
        if (rounded < boundary) rounded = __builtin_nextafterf(rounded, kInfinity);
    }
    return rounded <= bound && rounded < kInfinity;
}

RAYSCOPE_INLINE Float4 smaller(Float4 a, Float4 b) { return b < a ? b : a; }
RAYSCOPE_INLINE Float4 larger(Float4 a, Float4 b) { return b > a ? b : a; }

/// A ray prepared for the exact test, its axes permuted such that z comes last.
struct ExactRay {
    PermutedRay permuted;
    BoxRay box;
    float tMin;

    RAYSCOPE_INLINE ExactRay(Float4 origin, Float4 direction, float t0, float t1)
        : permuted(origin, direction), box(origin, direction, t0, t1), tMin(t0 > 0.0f ? t0 : 0.0f) {}
};

/// Tests one triangle, whose corners have their axes permuted like the ray; on success `found` has t, u and
/// v.
RAYSCOPE_INLINE bool hitsTriangle(const ExactRay& ray, Float4 a, Float4 b, Float4 c, float bound,
                                  HitData& found) {
    TriangleHit hit;
    if (!intersectSheared(ray.permuted.scaleZ, shear(ray.permuted, a), shear(ray.permuted, b),
                          shear(ray.permuted, c), hit))
        return false;
    const Float4 lower = smaller(smaller(a, b), c), upper = larger(larger(a, b), c);
    if (!acceptHit(ray.box, ray.tMin, hit.t, lower, upper, bound, found.t)) return false;
    found.u = static_cast<float>(hit.u);
    found.v = static_cast<float>(hit.v);
    return true;
}

}  // namespace rayscope::bvh::kernel
