#pragma once
// Tests of single primitives, with order-independent hit acceptance.
#include <rayscope/accel.h>
#include <algorithm>

#include "bvh/intersect/intersect_box.h"
#include "bvh/intersect/intersect_sphere.h"
#include "bvh/intersect/intersect_triangle.h"

namespace rayscope::bvh {

/// The planes of the box of one primitive.
struct PrimitiveBox {
    float planes[8];
    kernel::Float4 lower() const { return kernel::load4(planes); }
    kernel::Float4 upper() const { return kernel::load4(planes + 4); }
};

inline PrimitiveBox boxOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 lower = glm::min(a, glm::min(b, c)), upper = glm::max(a, glm::max(b, c));
    return {{lower.x, lower.y, lower.z, 0.0f, upper.x, upper.y, upper.z, 0.0f}};
}

/// See kernel::sphereBox().
PrimitiveBox boxOf(const Sphere& sphere);

/// A ray prepared for boxes, triangles and spheres. The kernels of the wide tree give the same hits.
struct RayQuery {
    static bool isTraceable(const Ray& ray) { return kernel::isTraceable(rayData(ray)); }

    explicit RayQuery(const Ray& original);

    Ray ray;  ///< with a tMin that is not negative
    BoxRay box;
    ShearedRay sheared;

    /// Tests one primitive. On success `found` has t, u and v.
    bool hits(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float bound, Hit& found) const {
        TriangleHit hit;
        if (!intersectTriangle(sheared, a, b, c, hit)) return false;
        const PrimitiveBox own = boxOf(a, b, c);
        if (!acceptHit(box, ray.tMin, hit.t, own.lower(), own.upper(), bound, found.t)) return false;
        found.u = static_cast<float>(hit.u);
        found.v = static_cast<float>(hit.v);
        return true;
    }
    bool hits(const Sphere& sphere, float bound, Hit& found) const;
};

/// Keeps the closer hit; of equal t the smaller primitive number.
inline bool keepCloser(const Hit& found, Hit& best) {
    if (found.t > best.t || (found.t == best.t && found.primitive > best.primitive)) return false;
    best = found;
    return true;
}

}  // namespace rayscope::bvh
