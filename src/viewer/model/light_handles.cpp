#include "viewer/model/light_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rayscope::viewer {

namespace {

std::vector<glm::vec3> handles(const PointLight& light) { return {light.position}; }
std::vector<glm::vec3> handles(const SegmentLight& light) {
    return {(light.endpoints[0] + light.endpoints[1]) * 0.5f, light.endpoints[0], light.endpoints[1]};
}
std::vector<glm::vec3> handles(const ParallelogramLight& light) {
    return {light.corner + (light.edges[0] + light.edges[1]) * 0.5f, light.corner,
            light.corner + light.edges[0], light.corner + light.edges[1]};
}

void move(PointLight& light, int, glm::vec3 delta) { light.position += delta; }
void move(SegmentLight& light, int handle, glm::vec3 delta) {
    if (handle != 2) light.endpoints[0] += delta;
    if (handle != 1) light.endpoints[1] += delta;
}
void move(ParallelogramLight& light, int handle, glm::vec3 delta) {
    if (handle <= 1) light.corner += delta;
    // Moving the corner keeps the ends of the edges in place.
    if (handle == 1) light.edges[0] -= delta;
    if (handle == 1) light.edges[1] -= delta;
    if (handle == 2) light.edges[0] += delta;
    if (handle == 3) light.edges[1] += delta;
}

/// The lines of the symbol of a light.
using Edges = std::vector<std::pair<glm::dvec3, glm::dvec3>>;
Edges edges(const PointLight&) { return {}; }
Edges edges(const SegmentLight& light) { return {{light.endpoints[0], light.endpoints[1]}}; }
Edges edges(const ParallelogramLight& light) {
    const glm::dvec3 a(light.corner), b = a + glm::dvec3(light.edges[0]), c = a + glm::dvec3(light.edges[1]),
                                      d = b + glm::dvec3(light.edges[1]);
    return {{a, b}, {a, c}, {b, d}, {c, d}};
}

double distanceToEdges(const ViewFrame& frame, const Light& light, glm::dvec2 cursor) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : std::visit([](const auto& shape) { return edges(shape); }, light.shape)) {
        const auto from = frame.project(a), to = frame.project(b);
        if (from && to) nearest = std::min(nearest, distanceToSegment(cursor, *from, *to));
    }
    return nearest;
}

/// Parameter of the point of the line center + s axis that is nearest to a ray; nothing if they are parallel.
std::optional<double> nearestOnAxis(glm::dvec3 center, glm::dvec3 axis, glm::dvec3 origin,
                                    glm::dvec3 direction) {
    const glm::dvec3 offset = center - origin;
    const double b = glm::dot(axis, direction);
    const double determinant = 1.0 - b * b;
    // Seen nearly end-on (within half a degree), a movement of one pixel would cross the whole scene.
    if (determinant < 1e-4) return std::nullopt;
    return (b * glm::dot(direction, offset) - glm::dot(axis, offset)) / determinant;
}

}  // namespace

std::vector<glm::vec3> handlePositions(const Light& light) {
    return std::visit([](const auto& shape) { return handles(shape); }, light.shape);
}

Light withHandleMoved(const Light& light, int handle, glm::vec3 newPosition) {
    Light moved = light;
    const glm::vec3 delta = newPosition - handlePositions(light)[static_cast<std::size_t>(handle)];
    std::visit([&](auto& shape) { move(shape, handle, delta); }, moved.shape);
    return moved;
}

const char* handleName(const Light& light, int handle) {
    if (handle == 0) return "whole light";
    if (std::holds_alternative<SegmentLight>(light.shape)) return handle == 1 ? "end 0" : "end 1";
    return handle == 1 ? "corner" : handle == 2 ? "end of edge 0" : "end of edge 1";
}

glm::dvec3 axisEnd(const ViewFrame& frame, glm::dvec3 center, HandlePart handlePart, const HandleSize& size) {
    return center + axisOf(handlePart) * (size.axis * frame.unitsPerPixelAt(center));
}

std::optional<HandlePart> pickHandlePart(const ViewFrame& frame, glm::dvec3 center, glm::dvec2 cursor,
                                         const HandleSize& size) {
    const auto middle = frame.project(center);
    if (!middle) return std::nullopt;
    if (glm::length(cursor - *middle) <= size.reach) return HandlePart::Free;
    std::optional<HandlePart> nearest;
    double nearestDistance = size.reach;
    for (const HandlePart handlePart : {HandlePart::X, HandlePart::Y, HandlePart::Z}) {
        const auto end = frame.project(axisEnd(frame, center, handlePart, size));
        if (!end) continue;
        const double distance = distanceToSegment(cursor, *middle, *end);
        if (distance > nearestDistance) continue;
        nearestDistance = distance;
        nearest = handlePart;
    }
    return nearest;
}

glm::dvec3 dragged(const ViewFrame& frame, glm::dvec3 center, HandlePart handlePart, glm::dvec2 grabbed,
                   glm::dvec2 cursor) {
    const glm::dvec3 before = frame.directionThrough(grabbed), now = frame.directionThrough(cursor);
    if (handlePart == HandlePart::Free) {
        const double depth = glm::dot(center - frame.eye, frame.forward);
        return center +
               depth * (now / glm::dot(now, frame.forward) - before / glm::dot(before, frame.forward));
    }
    const glm::dvec3 axis = axisOf(handlePart);
    const auto from = nearestOnAxis(center, axis, frame.eye, before);
    const auto to = nearestOnAxis(center, axis, frame.eye, now);
    return from && to ? center + axis * (*to - *from) : center;
}

std::optional<LightPick> pickLight(const ViewFrame& frame, const std::vector<Light>& lights,
                                   glm::dvec2 cursor, double reach) {
    std::optional<LightPick> nearest;
    double nearestDistance = reach;
    const auto consider = [&](std::size_t light, std::size_t handle, double distance) {
        if (distance > nearestDistance) return;
        nearestDistance = distance;
        nearest = LightPick{static_cast<int>(light), static_cast<int>(handle)};
    };
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::vector<glm::vec3> points = handlePositions(lights[i]);
        for (std::size_t handle = 0; handle < points.size(); ++handle)
            if (const auto projected = frame.project(glm::dvec3(points[handle])))
                consider(i, handle, glm::length(*projected - cursor));
    }
    if (nearest) return nearest;
    for (std::size_t i = 0; i < lights.size(); ++i) consider(i, 0, distanceToEdges(frame, lights[i], cursor));
    return nearest;
}

}  // namespace rayscope::viewer
