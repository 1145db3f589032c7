// Transforms, bounds and the framing camera of a scene description.
#include <rayscope/scene.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check_argument.h"
#include "math/vectors.h"
#include "scene/load_step.h"

namespace rayscope {

glm::dmat4 matrixOf(const Transform& transform) {
    if (transform.matrix) return glm::dmat4(*transform.matrix);
    const glm::dvec3 angles = glm::radians(glm::dvec3(transform.rotate));
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(transform.translate));
    matrix = glm::rotate(matrix, angles.z, glm::dvec3(0.0, 0.0, 1.0));
    matrix = glm::rotate(matrix, angles.y, glm::dvec3(0.0, 1.0, 0.0));
    matrix = glm::rotate(matrix, angles.x, glm::dvec3(1.0, 0.0, 0.0));
    return glm::scale(matrix, glm::dvec3(static_cast<double>(transform.scale)));
}

SceneBounds boundsOf(const SceneDescription& scene, const LoadControl& control) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 lower(kInfinity), upper(-kInfinity);
    const auto include = [&](const glm::dvec3& point) {
        if (!std::isfinite(point.x + point.y + point.z)) return;
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    };
    std::size_t vertices = 0;
    for (const MeshInstance& mesh : scene.meshes) {
        base::checkArgument(mesh.data != nullptr, "mesh '{}': data is null", mesh.name);
        vertices += mesh.data->positions.size();
    }
    scene::LoadStep step(control, "computing the bounds", vertices);
    for (const MeshInstance& mesh : scene.meshes) {
        const glm::dmat4 matrix = matrixOf(mesh.transform);
        for (const glm::vec3& position : mesh.data->positions) {
            include(glm::dvec3(matrix * glm::dvec4(glm::dvec3(position), 1.0)));
            step.advance();
        }
    }
    for (const SphereInstance& instance : scene.spheres) {
        const glm::dvec3 center(instance.sphere.center);
        include(center - static_cast<double>(instance.sphere.radius));
        include(center + static_cast<double>(instance.sphere.radius));
    }
    if (lower.x > upper.x) return {};
    return {glm::vec3(lower), glm::vec3(upper)};
}

CameraDescription framingCamera(const SceneBounds& bounds) {
    CameraDescription camera;
    const glm::dvec3 lower(bounds.lower), upper(bounds.upper);
    const glm::dvec3 center = 0.5 * (lower + upper);
    double radius = 0.5 * glm::length(upper - lower);
    // A single point: a distance that its float coordinates resolve.
    if (radius == 0.0) radius = std::max(0.5, glm::length(center) * 0x1p-10);
    // The bounding sphere touches the edges of the view at the distance radius / sin(fov / 2).
    const double distance = 1.05 * radius / std::sin(glm::radians(0.5 * static_cast<double>(camera.fov)));
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.0, 0.35, 1.0));
    camera.lookAt = glm::vec3(center);
    camera.lookFrom = math::toFiniteFloat(center + distance * direction);
    return camera;
}

}  // namespace rayscope
