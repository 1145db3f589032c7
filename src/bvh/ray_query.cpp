#include "bvh/ray_query.h"

#include <cmath>

namespace rayscope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool allFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Ray withoutNegativeT(Ray ray) {
    ray.tMin = std::max(ray.tMin, 0.0f);
    return ray;
}

}  // namespace

PrimitiveBox boxOf(const Sphere& sphere) {
    PrimitiveBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        box.planes[axis] = std::nextafter(sphere.center[axis] - sphere.radius, -kInfinity);
        box.planes[axis + 4] = std::nextafter(sphere.center[axis] + sphere.radius, kInfinity);
    }
    return box;
}

bool RayQuery::isTraceable(const Ray& ray) {
    return ray.tMin < ray.tMax && ray.tMax > 0.0f && allFinite(ray.origin) && allFinite(ray.direction) &&
           ray.direction != glm::vec3(0.0f);
}

RayQuery::RayQuery(const Ray& original) : ray(withoutNegativeT(original)), box(ray), sheared(ray) {}

bool RayQuery::accept(double t, const PrimitiveBox& own, float bound, float& rounded) const {
    rounded = static_cast<float>(t);
    if (!(rounded > ray.tMin && rounded <= bound && rounded < kInfinity)) return false;
    float entry;
    if (!intersectBox(own.planes, box, box.tMax, entry)) return false;
    if (rounded * box.scale < entry) {
        const double boundary = entry / box.scale;
        rounded = static_cast<float>(boundary);
        if (rounded < boundary) rounded = std::nextafter(rounded, kInfinity);
    }
    return rounded <= bound && rounded < kInfinity;
}

bool RayQuery::hits(const Sphere& sphere, float bound, Hit& found) const {
    double near, far;
    if (!intersectSphere(ray, sphere, near, far)) return false;
    const PrimitiveBox own = boxOf(sphere);
    if (!std::all_of(own.planes, own.planes + 8, [](float x) { return std::isfinite(x); })) return false;
    found.u = found.v = 0.0f;
    return accept(near, own, bound, found.t) || accept(far, own, bound, found.t);
}

}  // namespace rayscope
