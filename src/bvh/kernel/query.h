#pragma once
// When does a ray hit a triangle? The answer depends on the two alone, never on the way the search took.
#include "bvh/kernel/exact_triangle.h"

namespace rayscope::kernel {

/// Six planes in the layout of a BinaryNode: lower x, y, z, –, upper x, y, z, –.
using BoxPlanes = const float*;

/// Whether the ray meets the box between its tMin and `bound`; `entry` is where. See intersect_box.h.
RAYSCOPE_INLINE bool intersectBox(BoxPlanes box, const BoxRay& ray, float bound, float& entry) {
    float enter = ray.tMin;
    float leave = bound;
    for (int axis = 0; axis < 3; ++axis) {
        const int nearPlane = ray.nearPlane[axis];
        const int farPlane = nearPlane ^ 4;
        const float near = (box[nearPlane] - ray.origin[axis]) * ray.nearInverse[axis];
        const float far = (box[farPlane] - ray.origin[axis]) * ray.farInverse[axis];
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
    }
    entry = enter;
    return enter <= leave;
}

/// The words of a Hit.
struct HitWords {
    float t;
    uint32_t primitive;
    float u, v;
};

/// Rounds t, and accepts it if it lies in (tMin, bound] and the ray meets the primitive's own box. Where t
/// itself has lost digits (an origin very close to a large triangle) it may round to a value before that box;
/// then it is moved to where the box begins.
RAYSCOPE_INLINE bool accept(const BoxRay& ray, float tMin, double t, BoxPlanes own, float bound,
                            float& rounded) {
    rounded = static_cast<float>(t);
    if (!(rounded > tMin && rounded <= bound && rounded < kInfinity)) return false;
    float entry;
    if (!intersectBox(own, ray, ray.tMax, entry)) return false;
    if (rounded * ray.scale < entry) {
        const double boundary = entry / ray.scale;
        rounded = static_cast<float>(boundary);
        if (rounded < boundary) rounded = __builtin_nextafterf(rounded, kInfinity);
    }
    return rounded <= bound && rounded < kInfinity;
}

RAYSCOPE_INLINE float smallest(float a, float b, float c) {
    const float ab = b < a ? b : a;
    return c < ab ? c : ab;
}
RAYSCOPE_INLINE float largest(float a, float b, float c) {
    const float ab = b > a ? b : a;
    return c > ab ? c : ab;
}

/// Tests one triangle; on success `found` has t, u and v. `tMin` must not be negative.
RAYSCOPE_INLINE bool hitsTriangle(const BoxRay& box, const ShearedRay& sheared, float tMin, const float* a,
                                  const float* b, const float* c, float bound, HitWords& found) {
    TriangleHit hit;
    if (!intersectSheared(sheared, shear(sheared, a), shear(sheared, b), shear(sheared, c), hit))
        return false;
    float own[8];
    for (int axis = 0; axis < 3; ++axis) {
        own[axis] = smallest(a[axis], b[axis], c[axis]);
        own[axis + 4] = largest(a[axis], b[axis], c[axis]);
    }
    if (!accept(box, tMin, hit.t, own, bound, found.t)) return false;
    found.u = static_cast<float>(hit.u);
    found.v = static_cast<float>(hit.v);
    return true;
}

}  // namespace rayscope::kernel
