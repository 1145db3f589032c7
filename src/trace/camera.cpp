#include "trace/camera.h"

#include <cmath>
#include <numbers>

#include "math/frame.h"

namespace rayscope::trace {

Camera::Camera(const CameraDescription& description, int width, int height) : width_(width), height_(height) {
    position_ = glm::dvec3(description.lookFrom);
    forward_ = glm::normalize(glm::dvec3(description.lookAt) - position_);
    const glm::dvec3 right = glm::cross(forward_, glm::dvec3(description.up));
    // Looking exactly along `up` leaves the roll undefined: choose any.
    right_ = glm::length(right) > 0.0 ? glm::normalize(right) : math::frameAround(forward_).u;
    up_ = glm::cross(right_, forward_);
    tanHalfY_ = std::tan(static_cast<double>(description.fov) * std::numbers::pi / 360.0);
    tanHalfX_ = tanHalfY_ * width / height;
    pixelSize_ = {2.0 * tanHalfX_ / width, 2.0 * tanHalfY_ / height};
    if (description.lens) {
        const Lens& lens = *description.lens;
        lensRadius_ = static_cast<double>(lens.focalLength) / (2.0 * static_cast<double>(lens.fNumber));
        focusDistance_ = static_cast<double>(lens.focusDistance);
        inverseFocusDistance_ = 1.0 / focusDistance_;
    }
}

Ray Camera::lensRay(const glm::dvec2& pixel, const glm::dvec2& aperture) const {
    const glm::dvec2 lens = lensRadius_ * aperture;
    const glm::dvec3 direction = towards(onImagePlane(pixel) - lens * inverseFocusDistance_);
    return {glm::vec3(position_ + lens.x * right_ + lens.y * up_), glm::vec3(direction)};
}

glm::dvec2 Camera::project(const glm::dvec3& point) const {
    const glm::dvec3 offset = point - position_;
    const double depth = glm::dot(offset, forward_);
    const double x = glm::dot(offset, right_) / (depth * tanHalfX_),
                 y = glm::dot(offset, up_) / (depth * tanHalfY_);
    return {(x + 1.0) * 0.5 * width_, (1.0 - y) * 0.5 * height_};
}

}  // namespace rayscope::trace
