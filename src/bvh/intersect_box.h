#pragma once
// The conservative slab test of a ray against an axis-aligned box, in float.
//
// Distances are measured in units of the direction divided by a power of two, chosen so that its longest
// component lies in [1, 2): nothing overflows or underflows because of the length of the direction.
//
// A plane distance fl(fl(plane − origin) · fl(1/d)) has a relative error of at most 3u (1 + u), u = 2^-24.
// The reciprocals of near planes are shortened and those of far planes lengthened by 8u, so that a computed
// near distance is never beyond, and a far distance never before the true one rounded to float. Planes are
// chosen by the sign bit, and comparisons keep the running bound when a distance is NaN (0 · ∞: the ray runs
// inside the plane), so that such an axis excludes nothing.
//
// Subtraction, multiplication and rounding are monotone: if one box contains another, its computed interval
// contains that of the other as well. Hits are accepted only inside the interval of their own primitive's box
// (see RayQuery), so no ancestor can ever be culled that holds the answer, whatever the order of the search.
#include <rayscope/ray.h>

#include "bvh/binary_tree.h"

namespace rayscope {

/// What the test needs of a ray, computed once per ray. The direction must be finite and not zero.
struct BoxRay {
    explicit BoxRay(const Ray& ray);

    float origin[3];
    float nearInverse[3];
    float farInverse[3];
    int nearPlane[3];  ///< index of the near plane among the eight words of a BinaryNode
    float tMin;        ///< scaled
    float tMax;        ///< scaled
    double scale;      ///< power of two: distance = t * scale

    /// The distance that stands for t; never below any float distance that does not exceed the true value.
    float distance(float t) const { return static_cast<float>(t * scale); }
};

/// Six planes in the layout of a BinaryNode: lower x, y, z, –, upper x, y, z, –.
using BoxPlanes = const float*;

inline BoxPlanes planes(const BinaryNode& node) { return reinterpret_cast<const float*>(&node); }

/// Whether the ray meets the box between its tMin and `bound`; `entry` is where.
inline bool intersectBox(BoxPlanes box, const BoxRay& ray, float bound, float& entry) {
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

}  // namespace rayscope
