#pragma once
// Vector functions that GLM lacks.
#include <rayscope/vector.h>

#include <cmath>
#include <limits>

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

/// Rounds to float; what lies beyond its range becomes the largest float.
inline glm::vec3 toFiniteFloat(const glm::dvec3& v) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return glm::vec3(glm::clamp(v, -kLargest, kLargest));
}

/// Luminance of a linear colour (ITU-R BT.709).
template <class T>
T luminance(const glm::vec<3, T>& c) {
    return static_cast<T>(0.2126) * c.x + static_cast<T>(0.7152) * c.y + static_cast<T>(0.0722) * c.z;
}

}  // namespace rayscope::math
