#include "bvh/intersect/ray_query.h"

#include <cmath>

#include "bvh/kernel/sphere.h"

namespace rayscope::bvh {
namespace {

Ray withoutNegativeT(Ray ray) {
    ray.tMin = std::max(ray.tMin, 0.0f);
    return ray;
}

}  // namespace

PrimitiveBox boxOf(const Sphere& sphere) {
    PrimitiveBox box{};
    for (int axis = 0; axis < 3; ++axis) {
        box.planes[axis] = std::nextafter(sphere.center[axis] - sphere.radius, -kernel::kInfinity);
        box.planes[axis + 4] = std::nextafter(sphere.center[axis] + sphere.radius, kernel::kInfinity);
    }
    return box;
}

RayQuery::RayQuery(const Ray& original)
    : ray(withoutNegativeT(original)), box(rayData(ray)), sheared(rayData(ray)) {}

bool RayQuery::hits(const Sphere& sphere, float bound, Hit& found) const {
    kernel::HitData hit;
    if (!kernel::hitsSphere(rayData(ray), &sphere.center.x, bound, hit)) return false;
    found.t = hit.t;
    found.u = found.v = 0.0f;
    return true;
}

bool kernel::hitsSphere(RayData words, const float* record, float bound, HitData& found) {
    const Ray ray{{words[0], words[1], words[2]}, {words[3], words[4], words[5]}};
    const Sphere sphere{{record[0], record[1], record[2]}, record[3]};
    double near, far;
    if (!intersectSphere(ray, sphere, near, far)) return false;
    const PrimitiveBox own = boxOf(sphere);
    if (!std::all_of(own.planes, own.planes + 8, [](float x) { return std::isfinite(x); })) return false;
    found.u = found.v = 0.0f;
    const BoxRay box(words);
    const float tMin = std::max(words[6], 0.0f);
    return acceptHit(box, tMin, near, own.lower(), own.upper(), bound, found.t) ||
           acceptHit(box, tMin, far, own.lower(), own.upper(), bound, found.t);
}

}  // namespace rayscope::bvh
