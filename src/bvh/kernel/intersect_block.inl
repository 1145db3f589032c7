// A ray against a block of triangles. Include after one of the lanes_*.inl.
#include "bvh/kernel/hit_acceptance.h"
#include "bvh/kernel/prepare_rays.h"
#include "bvh/kernel/wide_layout.h"

namespace rayscope::bvh::kernel {
namespace {

/// The corners of one triangle per lane, in the space of the ray of that lane.
struct ShearedCorners {
    Lanes x[3], y[3], z[3];

    RAYSCOPE_INLINE void set(int corner, Lanes alongX, Lanes alongY, Lanes alongZ, Lanes shearX,
                             Lanes shearY) {
        x[corner] = subtractProduct(alongX, shearX, alongZ);
        y[corner] = subtractProduct(alongY, shearY, alongZ);
        z[corner] = alongZ;
    }
};

/// The result of the float test: the lanes in which the exact test may find a hit, and those in which it
/// certainly does.
struct FilterResult {
    unsigned possible;
    Lanes least, most, begin, end;  ///< |det| · t with its error, and |det| times the bounds of t
    Lanes lowest, highest, error;   ///< of the edge functions
    unsigned bounded;               ///< lanes in which nothing overflows

    RAYSCOPE_INLINE unsigned certain() const {
        const unsigned inside = less(error, lowest) | less(highest, Lanes::broadcast(0.0f) - error);
        return possible & bounded & inside & less(begin, least) & less(most, end);
    }
};

/// Tests the lanes `present`: bounded errors in float.
///
/// With u = 2^-24 and m the largest absolute coordinate of a corner relative to the origin, a sheared
/// coordinate has an error of at most 6um. With X the largest sheared coordinate plus 8um (`size`), an edge
/// function has an error of at most 4 · 6um · X + 2 · (6um)² + 4uX² < 40umX, because X ≤ 2m + 8um. A lane
/// is left out if two of its edge functions differ in sign by more than `error`, which is larger: m is at
/// most the largest sheared coordinate plus the largest depth (`reach`), up to 10u, since no slope exceeds 1.
///
/// Of the others the edge functions differ in sign by no more than the error, so the sum of their absolute
/// values is at most |det| + 6 errors; depths have an error of 4um. So |det| · t is known up to
/// m · (9 errors + 32u |det|), twice over, and a lane is left out if its hit lies before tMin or behind the
/// bound by more than that. Where products overflow, or come near the denormal numbers, nothing is left out.
///
/// Where all three edge functions have the same sign by more than the error, so have those of the exact test;
/// if the distance lies between tMin and bound by more than its margin, too, the exact test accepts the hit.
RAYSCOPE_INLINE FilterResult testCorners(const ShearedCorners& at, unsigned present, Lanes scaleZ, Lanes tMin,
                                         Lanes bound) {
    constexpr float kUnit = 0x1p-24f;
    const Lanes tiny = Lanes::broadcast(0x1p-120f), huge = Lanes::broadcast(0x1p100f);
    const auto &x = at.x, &y = at.y, &z = at.z;
    const Lanes extent =
        maximum(maximum(maximum(absolute(x[0]), absolute(y[0])), maximum(absolute(x[1]), absolute(y[1]))),
                maximum(absolute(x[2]), absolute(y[2])));
    const Lanes reach = extent + maximum(maximum(absolute(z[0]), absolute(z[1])), absolute(z[2]));
    const Lanes size = multiplyAdd(reach, Lanes::broadcast(8.0f * kUnit), extent);
    const Lanes error = multiplyAdd(reach * Lanes::broadcast(48.0f * kUnit), size, tiny);
    const Lanes u = subtractProduct(x[2] * y[1], y[2], x[1]);
    const Lanes v = subtractProduct(x[0] * y[2], y[0], x[2]);
    const Lanes w = subtractProduct(x[1] * y[0], y[1], x[0]);
    const Lanes highest = maximum(maximum(u, v), w), lowest = minimum(minimum(u, v), w);
    const unsigned mixed = less(error, highest) & less(lowest, Lanes::broadcast(0.0f) - error);
    present &= ~(mixed & less(error, huge));
    if (present == 0) return {0, tiny, tiny, tiny, tiny, tiny, tiny, tiny, 0};

    const Lanes signedDet = u + v + w, det = absolute(signedDet);
    const Lanes along = flipSign(multiplyAdd(u, z[0], multiplyAdd(v, z[1], w * z[2])) * scaleZ, signedDet);
    const Lanes margin = multiplyAdd(
        reach, multiplyAdd(error, Lanes::broadcast(9.0f), det * Lanes::broadcast(32.0f * kUnit)), tiny);
    const Lanes least = along - margin, most = along + margin, begin = tMin * det, end = bound * det;
    const unsigned bounded = less(margin, huge);
    const unsigned possible = present & ~((less(most, begin) | less(end, least)) & bounded);
    return {possible, least, most, begin, end, lowest, highest, error, bounded};
}

/// One ray and the triangles of a block.
RAYSCOPE_INLINE FilterResult filterTriangles(const TriangleBlock& block, ChildRef leaf, const FastShear& ray,
                                             float tMin, float bound) {
    const Lanes shearX = Lanes::broadcast(ray.shearX), shearY = Lanes::broadcast(ray.shearY);
    ShearedCorners at;
    for (int corner = 0; corner < 3; ++corner) {
        const auto& rows = block.corner[corner];
        at.set(corner, Lanes::load(rows[ray.axes.kx]) - Lanes::broadcast(ray.origin[0]),
               Lanes::load(rows[ray.axes.ky]) - Lanes::broadcast(ray.origin[1]),
               Lanes::load(rows[ray.axes.kz]) - Lanes::broadcast(ray.origin[2]), shearX, shearY);
    }
    return testCorners(at, (1u << trianglesIn(leaf)) - 1u, Lanes::broadcast(ray.scaleZ),
                       Lanes::broadcast(tMin), Lanes::broadcast(bound));
}

/// Eight rays with their bounds, and one triangle of a block.
RAYSCOPE_INLINE FilterResult filterTriangles(const TriangleBlock& block, int triangle, const RayColumns& rays,
                                             const RayAxes& axes, Lanes bound, unsigned present) {
    const Lanes shearX = Lanes::load(rays.shearX), shearY = Lanes::load(rays.shearY);
    ShearedCorners at;
    for (int corner = 0; corner < 3; ++corner) {
        const auto& rows = block.corner[corner];
        at.set(corner, Lanes::broadcast(rows[axes.kx][triangle]) - Lanes::load(rays.origin[axes.kx]),
               Lanes::broadcast(rows[axes.ky][triangle]) - Lanes::load(rays.origin[axes.ky]),
               Lanes::broadcast(rows[axes.kz][triangle]) - Lanes::load(rays.origin[axes.kz]), shearX, shearY);
    }
    return testCorners(at, present, Lanes::load(rays.scaleZ), Lanes::load(rays.tMin), bound);
}

/// The exact test of triangles of a block.
struct BlockRay {
    ExactRay exact;
    RayAxes axes;

    RAYSCOPE_INLINE BlockRay(RayData ray, const FastShear& shear)
        : exact(shear.origin, shear.direction, ray[6], ray[7]), axes(shear.axes) {}
    RAYSCOPE_INLINE BlockRay(RayData ray, const RayAxes& order)
        : exact(order.permuted(ray), order.permuted(ray + 3), ray[6], ray[7]), axes(order) {}

    RAYSCOPE_INLINE bool hits(const TriangleBlock& block, int lane, float bound, HitData& found) const {
        const auto corner = [&](int i) {
            const auto& rows = block.corner[i];
            return Float4{rows[axes.kx][lane], rows[axes.ky][lane], rows[axes.kz][lane], 0.0f};
        };
        if (!hitsTriangle(exact, corner(0), corner(1), corner(2), bound, found)) return false;
        found.primitive = block.primitive[lane];
        return true;
    }
};

}  // namespace
}  // namespace rayscope::bvh::kernel
