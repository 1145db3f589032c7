#pragma once
// Watertight ray-triangle intersection: shear to ray space and edge functions with exact sign, all in double.
//
// The vertices are moved so that the ray starts at the origin and sheared so that it runs along z (Woop,
// Benthin, Wald 2013). A sheared vertex depends on ray and vertex only, and the sign of an edge function is
// that of the exact product of its two sheared end points; so two triangles that share an edge see the same
// line on exactly one side of it. A line that meets an edge or a vertex exactly is decided by Simulation of
// Simplicity (Edelsbrunner, Mücke 1990): as if it were moved by (ε, ε²) in the shear plane. A closed surface
// is therefore crossed without a leak, and a fan of triangles exactly once.
#include <rayscope/ray.h>
#include <cmath>
#include <limits>

namespace rayscope {

/// What the test needs of a ray, computed once per ray. The direction must be finite and not zero.
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

/// A vertex in the space in which the ray starts at the origin and runs along z; z is not divided by the
/// direction.
struct ShearedVertex {
    double x, y, z;
};

/// The difference of two floats is exact in double unless their exponents differ by more than 29; then it is
/// rounded, but in the same way for every triangle that has the vertex.
inline ShearedVertex shear(const ShearedRay& ray, const glm::vec3& vertex) {
    const double z = vertex[ray.kz] - ray.origin[ray.kz];
    return {(vertex[ray.kx] - ray.origin[ray.kx]) - ray.shearX * z,
            (vertex[ray.ky] - ray.origin[ray.ky]) - ray.shearY * z, z};
}

/// True only if two edge functions have opposite signs beyond doubt: the rounding error of fl(p·q − r·s) is
/// at most ε|pq| + ε|rs| + ε|pq − rs|(1 + ε) ≤ 2ε(1 + ε)²(|pq| + |rs|) with ε = 2^-53, which the sum below
/// rounded with factor 4ε exceeds; the smallest normal number stands for products that underflow.
inline bool surelyMisses(const ShearedVertex& a, const ShearedVertex& b, const ShearedVertex& c) {
    constexpr double kFactor = 2.0 * std::numeric_limits<double>::epsilon();
    constexpr double kFloor = std::numeric_limits<double>::min();
    const double cb = c.x * b.y, bc = c.y * b.x;
    const double ac = a.x * c.y, ca = a.y * c.x;
    const double ba = b.x * a.y, ab = b.y * a.x;
    const double u = cb - bc, boundU = kFactor * (std::abs(cb) + std::abs(bc)) + kFloor;
    const double v = ac - ca, boundV = kFactor * (std::abs(ac) + std::abs(ca)) + kFloor;
    const double w = ba - ab, boundW = kFactor * (std::abs(ba) + std::abs(ab)) + kFloor;
    const bool positive = (u > boundU) | (v > boundV) | (w > boundW);
    const bool negative = (u < -boundU) | (v < -boundV) | (w < -boundW);
    return positive & negative;
}

/// The exact test of a sheared triangle.
bool intersectSheared(const ShearedRay& ray, const ShearedVertex& a, const ShearedVertex& b,
                      const ShearedVertex& c, TriangleHit& hit);

/// Tests the whole line, without any bounds on t. Triangles without area as the ray sees them, or with NaN or
/// infinite coordinates, are never hit.
inline bool intersectTriangle(const ShearedRay& ray, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c, TriangleHit& hit) {
    const ShearedVertex sa = shear(ray, a), sb = shear(ray, b), sc = shear(ray, c);
    return !surelyMisses(sa, sb, sc) && intersectSheared(ray, sa, sb, sc, hit);
}

}  // namespace rayscope
