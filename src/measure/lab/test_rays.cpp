#include "measure/lab/test_rays.h"

#include <cmath>
#include <numbers>

#include "math/frame.h"

namespace rayscope::measure {

SharedFeature randomSharedFeature(const LabContext& context, LabRandom& random) {
    const auto& edges = context.mesh.edges();
    const auto& closed = context.mesh.closedVertices();
    if (!closed.empty() && random.coin()) {
        const std::uint32_t vertex = closed[random.below(closed.size())];
        return {context.mesh.trianglesAround(vertex), {vertex, vertex}, context.vertices[vertex]};
    }
    const SharedEdge& edge = edges[random.below(edges.size())];
    const glm::dvec3 a = context.vertices[edge.a], b = context.vertices[edge.b];
    return {edge.triangles, {edge.a, edge.b}, a + static_cast<double>(random.below(257)) / 256.0 * (b - a)};
}

Ray rayAtPoint(const LabContext& context, const glm::dvec3& point, LabRandom& random) {
    const double kind = random.real();
    Ray ray;
    if (kind < 0.2) {
        const auto axis = static_cast<int>(random.below(3));
        const double sign = random.coin() ? 1.0 : -1.0;
        ray.origin = glm::vec3(point);
        ray.origin[axis] = static_cast<float>(point[axis] - sign * context.size * random.real(0.01, 2.0));
        ray.direction = glm::vec3(random.coin() ? 0.0f : -0.0f);
        ray.direction[axis] = static_cast<float>(sign);
        return ray;
    }
    const double distance = kind < 0.4   ? std::pow(10.0, random.real(-5.0, -1.0))
                            : kind < 0.5 ? std::pow(10.0, random.real(0.5, 3.0))
                                         : random.real(0.1, 3.0);
    const glm::dvec3 from = kind < 0.4 ? point : context.center;
    ray.origin = glm::vec3(from + distance * context.size * random.onSphere());
    glm::dvec3 direction = point - glm::dvec3(ray.origin);
    if (random.coin()) direction = glm::normalize(direction);
    ray.direction = glm::vec3(direction);
    return ray;
}

Ray rayAtTriangle(const LabContext& context, std::uint32_t triangle, LabRandom& random) {
    double u = random.real(), v = random.real();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    if (random.coin()) u *= std::pow(10.0, random.real(-6.0, 0.0));
    const glm::dvec3 a = context.corner(triangle, 0), b = context.corner(triangle, 1),
                     c = context.corner(triangle, 2), point = a + u * (b - a) + v * (c - a);
    Ray ray;
    const double distance = context.size * std::pow(10.0, random.real(-2.0, 2.0));
    ray.origin = glm::vec3(point + distance * random.onSphere());
    ray.direction = glm::vec3(point - glm::dvec3(ray.origin));
    return ray;
}

glm::vec3 directionAbove(const glm::dvec3& normal, LabRandom& random) {
    const double sine = std::pow(10.0, random.real(-4.0, 0.0)),
                 phi = random.real(0.0, 2.0 * std::numbers::pi);
    const math::Frame frame = math::frameAround(normal);
    const double cosine = std::sqrt(1.0 - sine * sine);
    return glm::vec3(sine * normal + cosine * (std::cos(phi) * frame.u + std::sin(phi) * frame.v));
}

}  // namespace rayscope::measure
