#pragma once
#include <rayscope/vector.h>

#include <cmath>
#include <limits>

namespace rayscope::scene {

/// Twice the signed area of the triangle a, b, c; above 0 if it turns left. The sign is exact if the
/// differences of the coordinates are: the products are then subtracted with one rounding (Kahan's method)
/// where that matters.
inline double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 u = b - a, v = c - a;
    const double left = u.x * v.y, right = u.y * v.x, difference = left - right;
    constexpr double kBound = 2.0 * std::numeric_limits<double>::epsilon();
    if (std::abs(difference) > kBound * (std::abs(left) + std::abs(right))) return difference;
    return std::fma(u.x, v.y, -right) - std::fma(u.y, v.x, -right);
}

/// Whether the outline goes from a to b and back over itself to c, or stays at a point. Cutting b off then
/// leaves the polygon as it is.
inline bool isSpike(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return orientation(a, b, c) == 0.0 && glm::dot(a - b, c - b) >= 0.0;
}

}  // namespace rayscope::scene
