#include "scene/check_camera.h"

#include "math/vectors.h"

namespace rayscope::scene {

std::string_view problemOf(const CameraDescription& camera) {
    const bool isFinite =
        math::isFinite(camera.lookFrom) && math::isFinite(camera.lookAt) && math::isFinite(camera.up);
    if (!isFinite) return "look_from, look_at and up must be finite";
    const glm::dvec3 view = glm::dvec3(camera.lookAt) - glm::dvec3(camera.lookFrom);
    if (glm::length(view) == 0.0) return "look_from and look_at are the same point";
    const glm::dvec3 up(camera.up);
    if (glm::length(up) == 0.0) return "up must not be zero";
    // Below this sine of the angle the rounding of the float coordinates determines the rotation.
    constexpr double kSine = 4.0 * 0x1p-24;
    if (glm::length(glm::cross(glm::normalize(view), glm::normalize(up))) <= kSine)
        return "up is parallel to the viewing direction; change one of them";
    return {};
}

}  // namespace rayscope::scene
