#pragma once
// Vector functions that GLM lacks.
#include <rayscope/vector.h>

#include <cmath>

namespace rayscope::math {

/// Whether all elements are finite.
template <class T>
bool isFinite(const glm::vec<3, T>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The length of a vector and the distance of two points, in double, whose squares neither overflow nor
/// underflow for any floats.
inline double length(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }
inline double distance(const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(glm::dvec3(a), glm::dvec3(b));
}

/// Luminance of a linear colour (ITU-R BT.709).
template <class T>
T luminance(const glm::vec<3, T>& c) {
    return static_cast<T>(0.2126) * c.x + static_cast<T>(0.7152) * c.y + static_cast<T>(0.0722) * c.z;
}

}  // namespace rayscope::math
