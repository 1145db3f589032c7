#pragma once
#include <rayscope/vector.h>
#include <cmath>

namespace rayscope::math {

/// The tangents of a right-handed orthonormal frame u, v, n.
struct Frame {
    glm::dvec3 u, v;
};

/// A frame around the unit vector n. Duff et al. 2017, "Building an Orthonormal Basis, Revisited": branchless
/// and accurate near all axes.
inline Frame frameAround(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace rayscope::math
