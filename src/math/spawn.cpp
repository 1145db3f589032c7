#include "math/spawn.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayscope::math {

namespace {

/// The next larger float of one below infinity, as std::nextafter() without a call.
float nextUp(float x) {
    if (x == 0.0f) return std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::int32_t>(x);
    return std::bit_cast<float>(bits + (bits < 0 ? -1 : 1));
}

}  // namespace

double spawnDistance(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal) {
    const glm::dvec3 rounding = 0x1p-24 * glm::abs(point) + glm::dvec3(0x1p-149);
    return glm::dot(glm::abs(normal), rounding) + 0x1p-44 * std::max({magnitude.x, magnitude.y, magnitude.z});
}

glm::vec3 spawnOrigin(const glm::dvec3& point, const glm::dvec3& magnitude, const glm::dvec3& normal) {
    const glm::dvec3 offset = spawnDistance(point, magnitude, normal) * normal;
    glm::vec3 origin;
    for (int axis = 0; axis < 3; ++axis) {
        const double exact = point[axis] + offset[axis];
        float rounded = static_cast<float>(exact);
        // Round away from the surface.
        if (offset[axis] > 0.0 && static_cast<double>(rounded) < exact) rounded = nextUp(rounded);
        if (offset[axis] < 0.0 && static_cast<double>(rounded) > exact) rounded = -nextUp(-rounded);
        origin[axis] = rounded;
    }
    return origin;
}

}  // namespace rayscope::math
