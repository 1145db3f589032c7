#pragma once
#include <rayscope/ray.h>

#include <algorithm>

namespace rayscope::trace {

/// The ray from a surface point to a light sample, with t = 1 at the light sample. `toLight` is light − from
/// and `distance` its length.
///
/// The ray ends at t = 1 − slack, so that geometry modelled at the position of the light, the visible surface
/// of a lamp, does not occlude it.
///
/// Derivation: let d = light − from, D its length, n the unit normal of the lamp, θ the angle between d and
/// n, and S the largest |light_k| + |from_k|, so that |d_k| ≤ S. `from` is a float, hence exact. Two
/// roundings to float displace the lamp against the ray: that of the direction by at most 2^-24 |d_k| along
/// axis k, and that of the vertices of the lamp by at most 2^-24 |light_k| where they are about as far from
/// the origin as the light sample. The sum is e_k ≤ 2^-24 (2 |light_k| + |from_k|) ≤ 2^-23 S, and along the
/// ray |n·e| / cos θ ≤ √3 · 2^-23 S / cos θ. The rounding of tMax adds 2^-25. So the hit on the lamp has
///
///     1 − t ≤ √3 · 2^-23 S / (D cos θ) + 2^-25.
///
/// The slack 2^-22 S / D exceeds the first term for cos θ > √3 / 2. All components of e at their largest and
/// parallel to n are rare: in 360,000 random lamps and directions up to θ = 60°, 1 − t was at most 0.48 times
/// the slack; towards grazing angles, where 1 / cos θ diverges, no slack suffices. The price of the slack is
/// that occluders nearer to the light than 2^-22 S, two to four units in the last place, are missed.
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
