#pragma once
// Watertight ray-triangle intersection: shear to ray space and edge functions with exact sign, all in double.
//
// The vertices are moved so that the ray starts at the origin and sheared so that it runs along z (Woop,
// Benthin, Wald 2013). A sheared vertex depends on ray and vertex only, and the sign of an edge function is
// that of the exact product of its two sheared end points; so for two triangles that share an edge, the line
// passes on exactly one side of the edge. A line that intersects an edge or a vertex exactly is decided by
// Simulation of Simplicity (Edelsbrunner, Mücke 1990): as if it were moved by (ε, ε²) in the shear plane. A
// closed surface is therefore crossed without a leak, and a fan of triangles exactly once.
#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {

/// t in units of the ray's direction; u and v weigh the second and third vertex.
struct TriangleHit {
    double t, u, v;
};

/// A vertex in the space of the ray; z is not divided by the direction.
struct ShearedVertex {
    double x, y, z;
};

/// The difference of two floats is exact in double unless their exponents differ by more than 29; then it is
/// rounded, but in the same way for every triangle that has the vertex.
RAYSCOPE_INLINE ShearedVertex shear(const ShearedRay& ray, const float* vertex) {
    const double z = vertex[ray.kz] - ray.origin[ray.kz];
    return {(vertex[ray.kx] - ray.origin[ray.kx]) - ray.shearX * z,
            (vertex[ray.ky] - ray.origin[ray.ky]) - ray.shearY * z, z};
}

/// A ShearedRay whose axes are in the order in which its z comes last.
struct PermutedRay {
    Double4 origin;
    Double4 shear;  ///< x, y, 0, 0
    double scaleZ;

    RAYSCOPE_INLINE PermutedRay(Float4 from, Float4 direction)
        : origin(__builtin_convertvector(from, Double4)) {
        const Double4 along = __builtin_convertvector(direction, Double4);
        shear = Double4{along[0], along[1], 0.0, 0.0} / along[2];
        scaleZ = 1.0 / along[2];
    }
};

/// The same for a vertex in that order.
RAYSCOPE_INLINE ShearedVertex shear(const PermutedRay& ray, Float4 vertex) {
    const Double4 relative = __builtin_convertvector(vertex, Double4) - ray.origin;
    const Double4 sheared = relative - ray.shear * relative[2];
    return {sheared[0], sheared[1], relative[2]};
}

/// True only if two exact edge functions have opposite signs: the rounding error of fl(p·q − r·s) is at most
/// ε|pq| + ε|rs| + ε|pq − rs|(1 + ε) ≤ 2ε(1 + ε)²(|pq| + |rs|) with ε = 2^-53, which the sum below rounded
/// with factor 4ε exceeds; the smallest normal number bounds the error of products that underflow.
RAYSCOPE_INLINE bool certainlyMisses(const ShearedVertex& a, const ShearedVertex& b, const ShearedVertex& c) {
    constexpr double kFactor = 2.0 * __DBL_EPSILON__;
    constexpr double kFloor = __DBL_MIN__;
    const double cb = c.x * b.y, bc = c.y * b.x;
    const double ac = a.x * c.y, ca = a.y * c.x;
    const double ba = b.x * a.y, ab = b.y * a.x;
    const double u = cb - bc, boundU = kFactor * (__builtin_fabs(cb) + __builtin_fabs(bc)) + kFloor;
    const double v = ac - ca, boundV = kFactor * (__builtin_fabs(ac) + __builtin_fabs(ca)) + kFloor;
    const double w = ba - ab, boundW = kFactor * (__builtin_fabs(ba) + __builtin_fabs(ab)) + kFloor;
    const bool positive = (u > boundU) | (v > boundV) | (w > boundW);
    const bool negative = (u < -boundU) | (v < -boundV) | (w < -boundW);
    return positive & negative;
}

/// a·b − c·d with an error of at most 1.5 ulp (Kahan; Jeannerod, Louvet, Muller 2013), so with the exact
/// sign.
RAYSCOPE_INLINE double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    return __builtin_fma(a, b, -cd) + __builtin_fma(-c, d, cd);
}

/// Sign of p.x·q.y − p.y·q.x; zero is decided as if both points were moved by (−ε, −ε²).
RAYSCOPE_INLINE int edgeSign(double edge, const ShearedVertex& p, const ShearedVertex& q) {
    if (edge != 0.0) return edge > 0.0 ? 1 : -1;
    if (p.y != q.y) return p.y > q.y ? 1 : -1;
    return (q.x > p.x) - (q.x < p.x);
}

/// Whether the line passes inside, where an edge function may be zero.
RAYSCOPE_INLINE bool isInsideOnEdge(double u, double v, double w, const ShearedVertex& a,
                                    const ShearedVertex& b, const ShearedVertex& c) {
    const int side = edgeSign(u, c, b);
    return side != 0 && edgeSign(v, a, c) == side && edgeSign(w, b, a) == side;
}

/// The exact test of a sheared triangle.
RAYSCOPE_INLINE bool intersectSheared(double scaleZ, const ShearedVertex& a, const ShearedVertex& b,
                                      const ShearedVertex& c, TriangleHit& hit) {
    const double u = differenceOfProducts(c.x, b.y, c.y, b.x);
    const double v = differenceOfProducts(a.x, c.y, a.y, c.x);
    const double w = differenceOfProducts(b.x, a.y, b.y, a.x);
    const bool inside = ((u > 0.0) & (v > 0.0) & (w > 0.0)) | ((u < 0.0) & (v < 0.0) & (w < 0.0));
    if (!inside && !isInsideOnEdge(u, v, w, a, b, c)) return false;

    const double det = u + v + w;
    hit.t = (u * a.z + v * b.z + w * c.z) * scaleZ / det;
    hit.u = v / det;
    hit.v = w / det;
    return __builtin_isfinite(hit.t);
}

}  // namespace rayscope::bvh::kernel
