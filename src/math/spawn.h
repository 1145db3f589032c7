#pragma once
#include <rayscope/vector.h>

namespace rayscope::math {

/// The origin of a ray spawned on a surface: a float point close to `point`, on the side of the surface to
/// which `normal` points for every rounding of the computation of `point`.
///
/// `point` is a surface point in double precision, `magnitude` a per-axis bound of the absolute values of the
/// coordinates that it was computed from (the largest of the three is used), and `normal` the unit geometric
/// normal on the side of the spawned ray.
///
/// Derivation: rounding `point` to float moves each coordinate by at most 2^-24 |p|, or 2^-149 for subnormal
/// numbers; the offset is the extent of this box along the normal, and the final rounding is away from the
/// surface. The double arithmetic that computed the point, and that tests the spawned ray against the same
/// surface, has an error along the normal of at most 2^-45 of the largest coordinate for triangles that are
/// not slivers (see bvh/intersect/hit_error.h: 48 · 2^-50 in the worst case, typically a hundredth of that).
/// This second term matters where the first nearly vanishes: in planes through the origin that are tilted
/// against two axes by less than float resolves, such as after a rotation by 180 degrees.
glm::vec3 spawnOrigin(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

/// The offset of spawnOrigin() along the normal before the final rounding, in the unit of `point`.
double spawnDistance(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

}  // namespace rayscope::math
