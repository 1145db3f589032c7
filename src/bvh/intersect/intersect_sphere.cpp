#include "bvh/intersect/intersect_sphere.h"

#include <cmath>
#include <utility>

namespace rayscope::bvh {

bool intersectSphere(const Ray& ray, const Sphere& sphere, double& near, double& far) {
    if (!(sphere.radius > 0.0f)) return false;
    const glm::dvec3 direction = ray.direction;
    const glm::dvec3 fromCenter = glm::dvec3(ray.origin) - glm::dvec3(sphere.center);
    const double radius = sphere.radius;

    const double a = glm::dot(direction, direction);
    const double b = -glm::dot(fromCenter, direction);
    const glm::dvec3 closest = fromCenter + (b / a) * direction;  // of the line to the center
    const double discriminant = radius * radius - glm::dot(closest, closest);
    if (!(discriminant >= 0.0)) return false;

    // Solve a t² − 2 b t + c = 0 without subtracting nearly equal numbers.
    const double distance = std::sqrt(glm::dot(fromCenter, fromCenter));
    const double c = (distance - radius) * (distance + radius);
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    far = q / a;
    near = q != 0.0 ? c / q : far;
    if (near > far) std::swap(near, far);
    return std::isfinite(near) && std::isfinite(far);
}

bool intersectSphere(const Ray& ray, const Sphere& sphere, float tMin, float tMax, double& t) {
    double near, far;
    if (!intersectSphere(ray, sphere, near, far)) return false;
    for (const double root : {near, far}) {
        const float rounded = static_cast<float>(root);
        if (rounded > tMin && rounded <= tMax) {
            t = root;
            return true;
        }
    }
    return false;
}

}  // namespace rayscope::bvh
