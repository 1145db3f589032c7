#include "viewer/model/projection.h"

#include <algorithm>
#include <cmath>

#include "math/frame.h"

namespace rayscope::viewer {

glm::dvec3 ViewFrame::directionThrough(glm::dvec2 pixel) const {
    const double x = (2.0 * pixel.x / width - 1.0) * tanHalfFov * aspect();
    const double y = (1.0 - 2.0 * pixel.y / height) * tanHalfFov;
    return glm::normalize(forward + x * right + y * up);
}

std::optional<glm::dvec2> ViewFrame::project(glm::dvec3 point) const {
    const glm::dvec3 offset = point - eye;
    const double depth = glm::dot(offset, forward);
    if (!(depth > 0.0)) return std::nullopt;
    const double x = glm::dot(offset, right) / (depth * tanHalfFov * aspect());
    const double y = glm::dot(offset, up) / (depth * tanHalfFov);
    return glm::dvec2((x + 1.0) * 0.5 * width, (1.0 - y) * 0.5 * height);
}

std::optional<std::array<glm::dvec2, 2>> ViewFrame::projectSegment(glm::dvec3 a, glm::dvec3 b) const {
    const double nearest = 1e-3 * (glm::distance(eye, a) + glm::distance(eye, b));
    const double depthA = glm::dot(a - eye, forward) - nearest;
    const double depthB = glm::dot(b - eye, forward) - nearest;
    if (depthA <= 0.0 && depthB <= 0.0) return std::nullopt;
    if (depthA < 0.0) a = glm::mix(a, b, depthA / (depthA - depthB));
    if (depthB < 0.0) b = glm::mix(b, a, depthB / (depthB - depthA));
    const auto start = project(a), end = project(b);
    if (!start || !end) return std::nullopt;
    return std::array{*start, *end};
}

double ViewFrame::unitsPerPixelAt(glm::dvec3 point) const {
    return 2.0 * tanHalfFov * std::abs(glm::dot(point - eye, forward)) / height;
}

ViewFrame viewFrame(const CameraDescription& camera, int width, int height) {
    ViewFrame frame;
    frame.eye = glm::dvec3(camera.lookFrom);
    frame.width = std::max(width, 1);
    frame.height = std::max(height, 1);
    frame.tanHalfFov = std::tan(glm::radians(static_cast<double>(camera.fov)) / 2.0);
    const glm::dvec3 view = glm::dvec3(camera.lookAt) - frame.eye;
    if (glm::length(view) > 0.0) frame.forward = glm::normalize(view);

    const glm::dvec3 sideways = glm::cross(frame.forward, glm::dvec3(camera.up));
    frame.right = glm::length(sideways) > 0.0 ? glm::normalize(sideways) : math::frameAround(frame.forward).u;
    frame.up = glm::cross(frame.right, frame.forward);
    return frame;
}

double distanceToSegment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * along);
}

double drawingUnit(double size) {
    if (!(size > 0.0) || (size > 0x1p-40 && size < 0x1p40)) return 1.0;
    return std::exp2(std::clamp(std::floor(std::log2(size)), -120.0, 120.0));
}

glm::mat4 viewProjection(const ViewFrame& frame, const SceneBounds& bounds) {
    const glm::dvec3 center = (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper)) * 0.5;
    const double radius = glm::length(glm::dvec3(bounds.upper) - center);
    const double depth = glm::dot(center - frame.eye, frame.forward);
    // Overlays extend beyond the geometry; 24 bits of depth suffice for a far/near ratio of some thousands.
    const double far = std::max(depth, 0.0) + 4.0 * radius;
    const double near = std::max(depth - 4.0 * radius, far * 2e-4);

    const double yScale = 1.0 / frame.tanHalfFov, xScale = yScale / frame.aspect();
    const double zScale = -(far + near) / (far - near), zOffset = -2.0 * far * near / (far - near);
    const glm::dmat4 projection(glm::dvec4(xScale, 0, 0, 0), glm::dvec4(0, yScale, 0, 0),
                                glm::dvec4(0, 0, zScale, -1), glm::dvec4(0, 0, zOffset, 0));
    const glm::dvec3 r = frame.right, u = frame.up, b = -frame.forward, e = frame.eye;
    const glm::dmat4 view(glm::dvec4(r.x, u.x, b.x, 0), glm::dvec4(r.y, u.y, b.y, 0),
                          glm::dvec4(r.z, u.z, b.z, 0),
                          glm::dvec4(-glm::dot(r, e), -glm::dot(u, e), -glm::dot(b, e), 1));
    return glm::mat4(projection * view * (1.0 / drawingUnit(radius)));
}

}  // namespace rayscope::viewer
