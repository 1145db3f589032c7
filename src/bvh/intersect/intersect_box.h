#pragma once
// The conservative slab test of a ray against an axis-aligned box, in float: kernel::intersectBox().
//
// A plane distance fl(fl(plane − origin) · fl(1/d)) has a relative error of at most 3u (1 + u), u = 2^-24.
// The reciprocals of near planes are shortened and those of far planes lengthened by 8u, so that a computed
// near distance is never beyond, and a far distance never before the true one rounded to float. Planes are
// chosen by the sign bit, and comparisons keep the other bound when a distance is NaN (0 · ∞: the ray runs
// inside the plane), so that such an axis excludes nothing.
//
// Subtraction, multiplication and rounding are monotone: if one box contains another, its computed interval
// contains that of the other as well. Hits are accepted only inside the interval of their own primitive's box
// (see kernel::acceptHit()), so no ancestor of the closest hit is culled, in any order of
// traversal.
#include "bvh/binary_tree.h"
#include "bvh/intersect/ray_data.h"
#include "bvh/kernel/hit_acceptance.h"

namespace rayscope::bvh {

using kernel::BoxPlanes;
using kernel::BoxRay;
using kernel::intersectBox;

inline BoxPlanes planes(const BinaryNode& node) { return reinterpret_cast<const float*>(&node); }

}  // namespace rayscope::bvh
