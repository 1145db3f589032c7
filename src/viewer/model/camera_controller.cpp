#include "viewer/model/camera_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayscope::viewer {

namespace {

constexpr double kRadiansPerPixel = 0.3 * 3.14159265358979323846 / 180.0;
/// The smallest angle between view direction and up vector.
constexpr double kPoleMargin = 0.01;

/// Rodrigues' rotation of `v` about the unit vector `axis`.
glm::dvec3 rotate(glm::dvec3 v, glm::dvec3 axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1.0 - c));
}

/// Turns the vector `arm` about `up` by yaw, then toward or away from `up` by pitch, within the poles.
glm::dvec3 swing(glm::dvec3 arm, glm::dvec3 up, double yaw, double pitch) {
    const double fromUp = std::acos(std::clamp(glm::dot(glm::normalize(arm), up), -1.0, 1.0));
    const double wanted = std::clamp(fromUp + pitch, kPoleMargin, 3.14159265358979323846 - kPoleMargin);
    const glm::dvec3 side = glm::cross(up, arm);
    if (glm::length(side) > 0.0) arm = rotate(arm, glm::normalize(side), wanted - fromUp);
    return rotate(arm, up, yaw);
}

glm::dvec3 upOf(const CameraDescription& camera) {
    const glm::dvec3 up(camera.up);
    return glm::length(up) > 0.0 ? glm::normalize(up) : glm::dvec3(0.0, 1.0, 0.0);
}

}  // namespace

void orbit(CameraDescription& camera, glm::dvec2 dragged) {
    const glm::dvec3 target(camera.lookAt);
    const glm::dvec3 arm = glm::dvec3(camera.lookFrom) - target;
    if (!(glm::length(arm) > 0.0)) return;
    const glm::dvec3 turned =
        swing(arm, upOf(camera), -dragged.x * kRadiansPerPixel, -dragged.y * kRadiansPerPixel);
    camera.lookFrom = glm::vec3(target + turned);
}

void pan(CameraDescription& camera, glm::dvec2 dragged, int pictureHeight) {
    const ViewFrame frame = viewFrame(camera, 1, pictureHeight);
    const double unit = frame.unitsPerPixelAt(glm::dvec3(camera.lookAt));
    const glm::dvec3 shift = (-dragged.x * frame.right + dragged.y * frame.up) * unit;
    camera.lookFrom = glm::vec3(glm::dvec3(camera.lookFrom) + shift);
    camera.lookAt = glm::vec3(glm::dvec3(camera.lookAt) + shift);
}

void zoomToward(CameraDescription& camera, glm::dvec3 anchor, double factor) {
    const glm::dvec3 eye(camera.lookFrom), target(camera.lookAt);
    const glm::dvec3 newEye = anchor + (eye - anchor) * factor;
    const glm::dvec3 newTarget = anchor + (target - anchor) * factor;
    // Eye and target are stored as float32: a thousand steps between them leave three digits to the
    // direction.
    const double magnitude = std::max(glm::length(newEye), glm::length(newTarget));
    const double resolution = magnitude * std::numeric_limits<float>::epsilon();
    const double distance = glm::length(newEye - newTarget);
    const double farthest = 0.1 * static_cast<double>(std::numeric_limits<float>::max());
    if (distance < 1000.0 * resolution || !(magnitude < farthest)) return;
    camera.lookFrom = glm::vec3(newEye);
    camera.lookAt = glm::vec3(newTarget);
}

glm::dvec3 pointAtFocusDepth(const CameraDescription& camera, const ViewFrame& frame, glm::dvec2 pixel) {
    const double depth = glm::dot(glm::dvec3(camera.lookAt) - frame.eye, frame.forward);
    const glm::dvec3 direction = frame.directionThrough(pixel);
    return frame.eye + direction * (depth / glm::dot(direction, frame.forward));
}

void look(CameraDescription& camera, glm::dvec2 dragged) {
    const glm::dvec3 eye(camera.lookFrom);
    const glm::dvec3 arm = glm::dvec3(camera.lookAt) - eye;
    if (!(glm::length(arm) > 0.0)) return;
    const glm::dvec3 turned =
        swing(arm, upOf(camera), -dragged.x * kRadiansPerPixel, dragged.y * kRadiansPerPixel);
    camera.lookAt = glm::vec3(eye + turned);
}

void walk(CameraDescription& camera, glm::dvec3 step) {
    const ViewFrame frame = viewFrame(camera, 1, 1);
    const glm::dvec3 shift = step.x * frame.right + step.y * upOf(camera) + step.z * frame.forward;
    camera.lookFrom = glm::vec3(glm::dvec3(camera.lookFrom) + shift);
    camera.lookAt = glm::vec3(glm::dvec3(camera.lookAt) + shift);
}

void frameAll(CameraDescription& camera, const SceneBounds& bounds, double aspect) {
    const glm::dvec3 center = (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper)) * 0.5;
    const double radius = glm::length(glm::dvec3(bounds.upper) - center);
    const ViewFrame frame = viewFrame(camera, 1, 1);
    // The bounding sphere touches the narrower pair of the side planes of the view frustum.
    const double halfVertical = std::atan(frame.tanHalfFov);
    const double halfHorizontal = std::atan(frame.tanHalfFov * aspect);
    const double distance = radius / std::sin(std::min(halfVertical, halfHorizontal));
    camera.lookAt = glm::vec3(center);
    camera.lookFrom = glm::vec3(center - frame.forward * distance);
}

void viewAlong(CameraDescription& camera, glm::dvec3 from) {
    const glm::dvec3 target(camera.lookAt);
    const double distance = glm::length(glm::dvec3(camera.lookFrom) - target);
    const glm::dvec3 up = upOf(camera);
    glm::dvec3 direction = glm::normalize(from);
    // Along the up vector the roll of the camera is undefined.
    if (std::abs(glm::dot(direction, up)) > std::cos(kPoleMargin)) {
        const ViewFrame frame = viewFrame(camera, 1, 1);
        const glm::dvec3 level = glm::cross(up, frame.right);
        const double sign = glm::dot(direction, up) > 0.0 ? 1.0 : -1.0;
        direction = glm::normalize(up * (sign * std::cos(kPoleMargin)) - level * std::sin(kPoleMargin));
    }
    camera.lookFrom = glm::vec3(target + direction * distance);
}

double defaultFlySpeed(const SceneBounds& bounds) {
    constexpr double kSecondsAcross = 8.0;
    return glm::length(glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower)) / kSecondsAcross;
}

}  // namespace rayscope::viewer
