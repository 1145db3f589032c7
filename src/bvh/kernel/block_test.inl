// A ray against a block of triangles. Include after one of the lanes_*.inl.
#include "bvh/kernel/fast_ray.h"
#include "bvh/kernel/query.h"
#include "bvh/kernel/wide_tree.h"

namespace rayscope::kernel {
namespace {

/// Which triangles of a block the exact test may hit: a conservative filter in float.
///
/// With u = 2^-24 and m the largest absolute coordinate of a corner relative to the origin (`reach`), a
/// sheared coordinate has an error of at most 6um. With X the largest sheared coordinate plus 8um (`size`),
/// an edge function has an error of at most 4 · 6um · X + 2 · (6um)² + 4uX² < 48umX (`error`), because X ≤ 2m
/// + 8um. A triangle is left out if two of its edge functions differ in sign by more than that.
///
/// Of the others the edge functions differ in sign by no more than the error, so the sum of their absolute
/// values is at most |det| + 6 errors; depths have an error of 4um. So |det| · t is known up to
/// m · (9 errors + 32u |det|), twice over, and a triangle is left out if it lies before tMin or behind the
/// bound by more than that. Where products overflow, or come near the denormal numbers, nothing is left out.
RAYSCOPE_INLINE unsigned mayHit(const TriangleBlock& block, const FastShear& ray, float tMin, float bound) {
    constexpr float kUnit = 0x1p-24f;
    const Lanes shearX = Lanes::all(ray.shearX), shearY = Lanes::all(ray.shearY);
    Lanes x[3], y[3], z[3], reach = Lanes::all(0.0f), extent = Lanes::all(0.0f);
    for (int corner = 0; corner < 3; ++corner) {
        const auto& rows = block.corner[corner];
        const Lanes px = Lanes::load(rows[ray.kx]) - Lanes::all(ray.origin[0]);
        const Lanes py = Lanes::load(rows[ray.ky]) - Lanes::all(ray.origin[1]);
        z[corner] = Lanes::load(rows[ray.kz]) - Lanes::all(ray.origin[2]);
        x[corner] = subtractProduct(px, shearX, z[corner]);
        y[corner] = subtractProduct(py, shearY, z[corner]);
        reach = maximum(maximum(absolute(px), absolute(py)), maximum(absolute(z[corner]), reach));
        extent = maximum(maximum(absolute(x[corner]), absolute(y[corner])), extent);
    }
    const Lanes size = multiplyAdd(reach, Lanes::all(8.0f * kUnit), extent);
    const Lanes error = multiplyAdd(reach * Lanes::all(48.0f * kUnit), size, Lanes::all(0x1p-120f));
    const Lanes u = subtractProduct(x[2] * y[1], y[2], x[1]);
    const Lanes v = subtractProduct(x[0] * y[2], y[0], x[2]);
    const Lanes w = subtractProduct(x[1] * y[0], y[1], x[0]);
    const unsigned positive = less(error, maximum(maximum(u, v), w));
    const unsigned negative = less(minimum(minimum(u, v), w), Lanes::all(0.0f) - error);

    const Lanes scaleZ = Lanes::all(ray.scaleZ);
    const Lanes signedDet = u + v + w, det = absolute(signedDet);
    const Lanes along = withSignOf(
        multiplyAdd(u, z[0] * scaleZ, multiplyAdd(v, z[1] * scaleZ, w * (z[2] * scaleZ))), signedDet);
    const Lanes margin = multiplyAdd(
        reach, multiplyAdd(error, Lanes::all(9.0f), det * Lanes::all(32.0f * kUnit)), Lanes::all(0x1p-120f));
    const unsigned certain = less(margin, Lanes::all(0x1p100f));
    const unsigned before = less(along + margin, Lanes::all(tMin) * det);
    const unsigned behind = less(multiplyAdd(Lanes::all(bound), det, margin), along);
    return ~(((positive & negative) | before | behind) & certain) & 0xffu;
}

RAYSCOPE_INLINE unsigned candidates(const TriangleBlock& block, ChildRef leaf, const FastShear& ray,
                                    float tMin, float bound) {
    const unsigned present = (2u << ((leaf >> kBlockSizeShift) & 7u)) - 1u;
    return mayHit(block, ray, tMin, bound) & present;
}

/// The exact test of one triangle of a block.
RAYSCOPE_INLINE bool testTriangle(RayWords ray, const TriangleBlock& block, int lane, float bound,
                                  HitWords& found) {
    float corner[3][3];
    for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis) corner[i][axis] = block.corner[i][axis][lane];
    const BoxRay box(ray);
    const ShearedRay sheared(ray);
    const float tMin = ray[6] > 0.0f ? ray[6] : 0.0f;
    if (!hitsTriangle(box, sheared, tMin, corner[0], corner[1], corner[2], bound, found)) return false;
    found.primitive = block.primitive[lane];
    return true;
}

}  // namespace
}  // namespace rayscope::kernel
