#pragma once
#include <rayscope/vector.h>

namespace rayscope::math {

/// Where a ray that leaves a surface starts: the float point nearest to `point` that lies on the side of the
/// surface to which `normal` points, even if every rounding since `point` was computed went the wrong way.
///
/// `point` is a surface point in double, `magnitude` bounds the absolute values of the coordinates it was
/// computed from, per axis (the largest counts), and `normal` is the unit geometric normal on the side to
/// which the new ray goes.
///
/// Derivation: rounding `point` to float moves each coordinate by at most 2^-24 |p|, numbers below the normal
/// range by 2^-149; what that box reaches along the normal is made up for, and the final rounding goes away
/// from the surface. The arithmetic in double that found the point, and that will test the new ray against
/// the same surface, errs along the normal by at most 2^-45 of the largest coordinate for triangles that are
/// not slivers (see bvh/hit_error.h: 48 · 2^-50 in the worst case, a hundredth of that as a rule). This
/// counts where the first part nearly vanishes: in planes that pass through the origin and are tilted against
/// two axes by less than float resolves, as after a turn by 180 degrees.
glm::vec3 spawnOrigin(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

/// Bound of the distance between spawnOrigin() and the surface, for callers that state an accuracy.
double spawnDistance(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

}  // namespace rayscope::math
