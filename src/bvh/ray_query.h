#pragma once
// When does a ray hit a primitive? The answer depends on the two alone, never on the way the search took.
#include <rayscope/accel.h>
#include <algorithm>

#include "bvh/intersect_box.h"
#include "bvh/intersect_sphere.h"
#include "bvh/intersect_triangle.h"

namespace rayscope {

/// The planes of the box of one primitive.
struct PrimitiveBox {
    float planes[8];
};

inline PrimitiveBox boxOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 lower = glm::min(a, glm::min(b, c)), upper = glm::max(a, glm::max(b, c));
    return {{lower.x, lower.y, lower.z, 0.0f, upper.x, upper.y, upper.z, 0.0f}};
}

/// Rounded outward, because center ± radius is not a float in general.
PrimitiveBox boxOf(const Sphere& sphere);

/// A ray prepared for boxes, triangles and spheres.
struct RayQuery {
    /// Whether the ray can hit anything: finite, with a direction, and with room between tMin and tMax.
    static bool isTraceable(const Ray& ray);

    explicit RayQuery(const Ray& ray);

    Ray ray;
    BoxRay box;
    ShearedRay sheared;

    /// Rounds t, and accepts it if it lies in (tMin, bound] and the ray meets the primitive's own box.
    /// Where t itself has lost digits (an origin very close to a large triangle) it may round to a value
    /// before that box; then it is moved to where the box begins.
    bool accept(double t, const PrimitiveBox& own, float bound, float& rounded) const;

    /// Tests one primitive. On success `found` has t, u and v.
    bool hits(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float bound, Hit& found) const {
        TriangleHit hit;
        if (!intersectTriangle(sheared, a, b, c, hit)) return false;
        if (!accept(hit.t, boxOf(a, b, c), bound, found.t)) return false;
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

}  // namespace rayscope
