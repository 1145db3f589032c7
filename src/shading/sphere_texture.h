#pragma once
#include <rayscope/vector.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope::shading {

/// Texture coordinates of a sphere, from the unit vector from its centre: u is the longitude, 0 at +x, 1/4 at
/// −z, 1/2 at −x and 3/4 at +z, so that images are not mirrored when seen from outside; v the latitude from 0
/// at −y to just below 1 at +y. The generated `uv_sphere` has the same.
inline glm::dvec2 sphereTexCoords(const glm::dvec3& n) {
    const double turn = std::atan2(-n.z, n.x) / (2.0 * std::numbers::pi);
    const double height = 0.5 + std::atan2(n.y, std::hypot(n.x, n.z)) / std::numbers::pi;
    // 1 would repeat the texel at 0, that of the opposite pole.
    return {turn < 0.0 ? turn + 1.0 : turn, std::min(height, 1.0 - 0x1p-24)};
}

}  // namespace rayscope::shading
