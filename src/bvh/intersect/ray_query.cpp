#include "bvh/intersect/ray_query.h"

#include "bvh/kernel/sphere.h"

namespace rayscope::bvh {
namespace {

Ray withoutNegativeT(Ray ray) {
    ray.tMin = std::max(ray.tMin, 0.0f);
    return ray;
}

}  // namespace

PrimitiveBox boxOf(const Sphere& sphere) {
    PrimitiveBox box;
    kernel::sphereBox(sphereData(sphere), box.planes);
    return box;
}

RayQuery::RayQuery(const Ray& original)
    : ray(withoutNegativeT(original)), box(rayData(ray)), sheared(rayData(ray)) {}

bool RayQuery::hits(const Sphere& sphere, float bound, Hit& found) const {
    return kernel::hitsSphere(rayData(ray), sphereData(sphere), bound, *hitData(&found));
}

}  // namespace rayscope::bvh
