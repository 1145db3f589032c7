// Replaces src/bvh/kernel/intersect_block.inl in a benchmark: Möller and Trumbore 1997 in float, as the
// baseline for the cost of the sign-exact test. It is not watertight.
#include "bvh/kernel/hit_acceptance.h"
#include "bvh/kernel/prepare_rays.h"
#include "bvh/kernel/wide_layout.h"

namespace rayscope::bvh::kernel {
namespace {

/// Three lanes at a time.
struct Lanes3 {
    Lanes x, y, z;
};

RAYSCOPE_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
RAYSCOPE_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {subtractProduct(a.y * b.z, a.z, b.y), subtractProduct(a.z * b.x, a.x, b.z),
            subtractProduct(a.x * b.y, a.y, b.x)};
}
RAYSCOPE_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
    return multiplyAdd(a.x, b.x, multiplyAdd(a.y, b.y, a.z * b.z));
}

struct FilterResult {
    unsigned possible;
    static unsigned certain() { return 0; }
};

/// All eight triangles. The direction is that of the ray divided by its longest component, which comes last.
RAYSCOPE_INLINE FilterResult filterTriangles(const TriangleBlock& block, ChildRef leaf, const FastShear& ray,
                                             float tMin, float bound) {
    const auto corner = [&](int i) -> Lanes3 {
        const auto& rows = block.corner[i];
        return {Lanes::load(rows[ray.axes.kx]), Lanes::load(rows[ray.axes.ky]),
                Lanes::load(rows[ray.axes.kz])};
    };
    const Lanes3 direction{Lanes::broadcast(ray.shearX), Lanes::broadcast(ray.shearY),
                           Lanes::broadcast(1.0f)};
    const Lanes3 origin{Lanes::broadcast(ray.origin[0]), Lanes::broadcast(ray.origin[1]),
                        Lanes::broadcast(ray.origin[2])};
    const Lanes3 a = corner(0), edge1 = corner(1) - a, edge2 = corner(2) - a;
    const Lanes3 p = cross(direction, edge2), s = origin - a, q = cross(s, edge1);
    const Lanes signedDet = dot(edge1, p), det = absolute(signedDet), zero = Lanes::broadcast(0.0f);
    const Lanes u = flipSign(dot(s, p), signedDet), v = flipSign(dot(direction, q), signedDet);
    const Lanes t = flipSign(dot(edge2, q) * Lanes::broadcast(ray.scaleZ), signedDet);
    const unsigned inside = lessOrEqual(zero, u) & lessOrEqual(zero, v) & lessOrEqual(u + v, det);
    const unsigned inInterval =
        less(Lanes::broadcast(tMin) * det, t) & lessOrEqual(t, Lanes::broadcast(bound) * det);
    const unsigned present = (1u << trianglesIn(leaf)) - 1u;
    return {inside & inInterval & less(zero, det) & present};
}

/// No test of several rays at once: each is tested by BlockRay.
RAYSCOPE_INLINE FilterResult filterTriangles(const TriangleBlock&, int, const RayColumns&, const RayAxes&,
                                             Lanes, unsigned present) {
    return {present};
}

/// One triangle, for t and the barycentric weights.
struct BlockRay {
    RayData ray;

    RAYSCOPE_INLINE BlockRay(RayData data, const FastShear&) : ray(data) {}
    RAYSCOPE_INLINE BlockRay(RayData data, const RayAxes&) : ray(data) {}

    RAYSCOPE_INLINE bool hits(const TriangleBlock& block, int lane, float bound, HitData& found) const {
        float a[3], edge1[3], edge2[3], s[3], p[3], q[3];
        for (int i = 0; i < 3; ++i) {
            a[i] = block.corner[0][i][lane];
            edge1[i] = block.corner[1][i][lane] - a[i];
            edge2[i] = block.corner[2][i][lane] - a[i];
            s[i] = ray[i] - a[i];
        }
        const float* d = ray + 3;
        for (int i = 0; i < 3; ++i) {
            const int j = i == 2 ? 0 : i + 1, k = j == 2 ? 0 : j + 1;
            p[i] = d[j] * edge2[k] - d[k] * edge2[j];
            q[i] = s[j] * edge1[k] - s[k] * edge1[j];
        }
        const float inverse = 1.0f / (edge1[0] * p[0] + edge1[1] * p[1] + edge1[2] * p[2]);
        found.t = (edge2[0] * q[0] + edge2[1] * q[1] + edge2[2] * q[2]) * inverse;
        found.u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * inverse;
        found.v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) * inverse;
        found.primitive = block.primitive[lane];
        return found.t > ray[6] && found.t <= bound;
    }
};

}  // namespace
}  // namespace rayscope::bvh::kernel
