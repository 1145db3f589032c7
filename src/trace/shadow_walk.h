#pragma once
#include <algorithm>
#include <stop_token>

#include "trace/interaction.h"

namespace rayscope::trace {

/// The product of 1 − opacity over all surfaces that a shadow ray crosses. Calls `onRay` with each ray
/// before it is traced. After a stop request the result is meaningless.
template <class OnRay>
double transmittanceAlong(const World& world, const Ray& shadow, float time, const std::stop_token& stop,
                          const OnRay& onRay) {
    double passed = 1.0;
    Ray ray = shadow;
    const glm::dvec3 end = glm::dvec3(shadow.origin) + glm::dvec3(shadow.direction);
    Hit hit;
    while (passed >= 0x1p-64 && !stop.stop_requested()) {
        onRay(ray);
        if (!world.closestHit(ray, time, hit)) return passed;
        const Interaction at = interactionAt(world, ray, time, {}, hit);
        passed *= 1.0 - world.materials[at.material].opacity;
        // Continue behind the surface to the same end; the direction and its unit of t stay.
        ray.origin = at.originBehind();
        const glm::dvec3 rest = end - glm::dvec3(ray.origin);
        const double done = 1.0 - glm::dot(rest, glm::dvec3(shadow.direction)) /
                                      glm::dot(glm::dvec3(shadow.direction), glm::dvec3(shadow.direction));
        if (!(done < static_cast<double>(shadow.tMax))) return passed;
        ray.tMax = static_cast<float>(static_cast<double>(shadow.tMax) - done);
    }
    return 0.0;
}

}  // namespace rayscope::trace
