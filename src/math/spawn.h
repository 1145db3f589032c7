#pragma once
#include <rayscope/vector.h>

namespace rayscope {

/// Where a ray that leaves a surface starts: the float point nearest to `point` that lies on the side of the
/// surface to which `normal` points, even if every rounding since `point` was computed went the wrong way.
///
/// `point` is a surface point in double, `magnitude` bounds the absolute values of the coordinates it was
/// computed from, per axis, and `normal` is the unit geometric normal on the side to which the new ray goes.
///
/// Derivation: rounding `point` to float moves each coordinate by at most 2^-24 |p|; the double arithmetic
/// before it by at most 2^-50 of `magnitude` (eight operations of 2^-53 each); numbers below the normal range
/// by 2^-149. Moved along the normal by the projection of that box, the point cannot end below the surface;
/// the final rounding is made away from it.
glm::vec3 spawnOrigin(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

/// Bound of the distance between spawnOrigin() and the surface, for callers that state an accuracy.
double spawnDistance(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal);

}  // namespace rayscope
