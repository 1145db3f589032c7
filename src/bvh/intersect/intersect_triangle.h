#pragma once
// Watertight ray-triangle intersection; the method is described in kernel/exact_triangle.h.
#include "bvh/intersect/ray_data.h"
#include "bvh/kernel/exact_triangle.h"

namespace rayscope::bvh {

using kernel::ShearedRay;
using kernel::TriangleHit;

/// Tests the whole line, without any bounds on t. Triangles whose projection along the ray has no area, and
/// triangles with NaN or infinite coordinates, are never hit.
inline bool intersectTriangle(const ShearedRay& ray, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c, TriangleHit& hit) {
    const kernel::ShearedVertex sa = shear(ray, &a.x), sb = shear(ray, &b.x), sc = shear(ray, &c.x);
    return !certainlyMisses(sa, sb, sc) && intersectSheared(ray.scaleZ, sa, sb, sc, hit);
}

}  // namespace rayscope::bvh
