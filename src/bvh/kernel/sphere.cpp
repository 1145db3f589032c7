#include "bvh/kernel/sphere.h"

#include <rayscope/vector.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace rayscope::bvh::kernel {

bool intersectSphere(RayData ray, const float* sphere, double& near, double& far) {
    if (!(sphere[3] > 0.0f)) return false;
    const glm::dvec3 direction(ray[3], ray[4], ray[5]);
    const glm::dvec3 fromCenter =
        glm::dvec3(ray[0], ray[1], ray[2]) - glm::dvec3(sphere[0], sphere[1], sphere[2]);
    const double radius = sphere[3];

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

void sphereBox(const float* sphere, float (&planes)[8]) {
    planes[3] = planes[7] = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        planes[axis] = std::nextafter(sphere[axis] - sphere[3], -kInfinity);
        planes[axis + 4] = std::nextafter(sphere[axis] + sphere[3], kInfinity);
    }
}

int crossSphere(RayData ray, const float* sphere, float bound, HitData (&found)[2]) {
    double roots[2];
    if (!intersectSphere(ray, sphere, roots[0], roots[1])) return 0;
    float planes[8];
    sphereBox(sphere, planes);
    if (!std::all_of(planes, planes + 8, [](float x) { return std::isfinite(x); })) return 0;
    const BoxRay box(ray);
    const float tMin = std::max(ray[6], 0.0f);
    int count = 0;
    for (const double root : roots) {
        found[count] = {};
        count += acceptHit(box, tMin, root, load4(planes), load4(planes + 4), bound, found[count].t);
    }
    return count;
}

bool hitsSphere(RayData ray, const float* sphere, float bound, HitData& found) {
    HitData both[2];
    if (crossSphere(ray, sphere, bound, both) == 0) return false;
    found.t = both[0].t;
    found.u = found.v = 0.0f;
    return true;
}

}  // namespace rayscope::bvh::kernel
