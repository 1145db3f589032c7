#pragma once
#include <rayscope/ray.h>

#include <algorithm>

namespace rayscope::trace {

/// The ray from a surface to a position on a light; t = 1 is the light. The vector from one to the other is
/// known, and its length. It ends before the light by the
/// rounding of both ends, so that a lamp's own surface does not block it.
inline Ray shadowRay(const glm::vec3& from, const glm::dvec3& light, const glm::dvec3& toLight,
                     double distance) {
    Ray ray{from, glm::vec3(toLight)};
    const glm::dvec3 size = glm::abs(light) + glm::abs(glm::dvec3(from));
    const double slack = 0x1p-22 * std::max({size.x, size.y, size.z}) / distance;
    ray.tMax = static_cast<float>(std::max(0.0, 1.0 - slack));
    return ray;
}

inline Ray shadowRay(const glm::vec3& from, const glm::dvec3& light) {
    const glm::dvec3 toLight = light - glm::dvec3(from);
    return shadowRay(from, light, toLight, glm::length(toLight));
}

}  // namespace rayscope::trace
