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

/// Luminance of a linear colour (ITU-R BT.709).
template <class T>
T luminance(const glm::vec<3, T>& c) {
    return static_cast<T>(0.2126) * c.x + static_cast<T>(0.7152) * c.y + static_cast<T>(0.0722) * c.z;
}

}  // namespace rayscope::math
