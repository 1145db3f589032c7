#pragma once
// Watertight ray-triangle intersection: shear to ray space and edge functions with exact sign, all in double.
#include <rayscope/ray.h>

namespace rayscope {

/// What the test needs of a ray, computed once per ray.
struct ShearedRay {
    explicit ShearedRay(const Ray& ray);
    glm::dvec3 origin;
    double shearX, shearY, scaleZ;
    int kx, ky, kz;  ///< axes, z being the one along which the direction is longest
};

/// t in units of the ray's direction; u and v weigh the second and third vertex.
struct TriangleHit {
    double t, u, v;
};

/// Tests the whole line, without any bounds on t.
bool intersectTriangle(const ShearedRay& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                       TriangleHit& hit);

}  // namespace rayscope
