#pragma once
#include <rayscope/ray.h>

namespace rayscope::measure {

/// Where the line of a ray crosses a triangle, without rounding. Ray and triangle must be finite and the
/// direction not zero.
///
/// A line through an edge or a vertex is decided as by the tracer (see bvh/kernel/exact_triangle.h): as if it
/// were moved by (ε, ε²) in the plane across its longest direction. So lines cross closed surfaces an odd
/// number of times from inside, and this is the same for everyone who decides ties consistently.
struct ExactCrossing {
    bool crossed = false;
    bool parallel = false;  ///< the line lies in the triangle's plane, or the triangle has no area: no t
    /// In units of the direction, and the weights of the second and third corner; of the triangle's plane
    /// even if the line passes beside the triangle.
    long double t = 0.0L, u = 0.0L, v = 0.0L;
    /// Edge functions opposite to the three corners, in units of the sheared space; their sum is the
    /// determinant.
    long double edges[3] = {};

    ExactCrossing(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
};

}  // namespace rayscope::measure
