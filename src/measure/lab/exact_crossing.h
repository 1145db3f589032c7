#pragma once
#include <rayscope/ray.h>

namespace rayscope::measure {

/// The crossing of the line of a ray with a triangle, in exact arithmetic. Ray and triangle must be finite
/// and the direction not zero.
///
/// Ties at edges and vertices are broken as in the tracer (see bvh/kernel/exact_triangle.h), by a symbolic
/// translation of the line by (ε, ε²) across its longest direction. So every line from inside a closed
/// surface crosses it an odd number of times, which holds for any consistent tie-breaking rule.
struct ExactCrossing {
    bool crossed = false;
    bool parallel = false;  ///< the line lies in the triangle's plane, or the triangle has no area: no t
    /// In units of the direction, and the weights of the second and third corner; of the triangle's plane
    /// even if the line misses the triangle.
    long double t = 0.0L, u = 0.0L, v = 0.0L;
    /// Edge functions opposite to the three corners, in units of the sheared space; their sum is the
    /// determinant.
    long double edges[3] = {};

    ExactCrossing(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
};

}  // namespace rayscope::measure
