// Rays that run alike, tested together. Include after one of the lanes_*.inl.
//
// A packet is sixteen rays that agree in the signs and the longest component of their direction. A node is
// tested once for all of them, by interval arithmetic: from the least and largest origins and reciprocals of
// directions follows between which distances any of the rays could be in a box (Boulos, Wald and Shirley
// 2006). Only at the leaves every ray is tested by itself, eight at a time, against one triangle after the
// other.
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::bvh::kernel {
namespace {

constexpr uint32_t kPacketSize = 16;
constexpr uint32_t kPacketGroups = kPacketSize / kWidth;  ///< of eight rays

/// Distances that were computed from one difference, one reciprocal and one product, moved as far as the fast
/// test of a single ray moves them (see FastRay), and by more than the rounding of denormal numbers.
RAYSCOPE_INLINE Lanes padNear(Lanes near) {
    return multiplyAdd(near, Lanes::broadcast(1.0f - 0x1p-20f), Lanes::broadcast(-0x1p-120f));
}
RAYSCOPE_INLINE Lanes padFar(Lanes far) {
    return multiplyAdd(far, Lanes::broadcast(1.0f + 0x1p-20f), Lanes::broadcast(0x1p-120f));
}

RAYSCOPE_INLINE float horizontalMax(Lanes x) {
    alignas(32) float values[kWidth];
    x.store(values);
    float result = values[0];
    for (int i = 1; i < kWidth; ++i) result = values[i] > result ? values[i] : result;
    return result;
}

struct Packet {
    RayColumns columns[kPacketGroups];
    uint32_t firstRay;
    float scale;
    bool isSheared;
    PlaneRows rows;
    RayAxes axes;
    // Of all its rays, distances scaled:
    float nearOrigin[3], farOrigin[3];  ///< the ones closest to and farthest from the planes ahead
    float leastInverse[3], mostInverse[3];
    float tMin, bound;

    /// Takes up sixteen rays, whose columns are known, if they are alike.
    RAYSCOPE_INLINE bool gather(const float* rays, const PackedRay* prepared, uint32_t first) {
        Lanes leastWords = Lanes::loadUnaligned(rays), mostWords = leastWords;
        Lanes leastFast = Lanes::loadUnaligned(prepared->inverse), mostFast = leastFast;
        for (uint32_t i = 1; i < kPacketSize; ++i) {
            const Lanes words = Lanes::loadUnaligned(rays + 8 * i);
            leastWords = minimum(leastWords, words);
            mostWords = maximum(mostWords, words);
            const Lanes fast = Lanes::loadUnaligned(prepared[i].inverse);
            leastFast = minimum(leastFast, fast);
            mostFast = maximum(mostFast, fast);
        }
        alignas(32) float least[8], most[8], leastOf[8], mostOf[8];
        leastWords.store(least);
        mostWords.store(most);
        leastFast.store(leastOf);
        mostFast.store(mostOf);

        axes = RayAxes(rays);
        float shortest[3], longest[3];
        for (int axis = 0; axis < 3; ++axis) {
            if (!(leastOf[axis] * mostOf[axis] > 0.0f)) return false;
            const bool backward = leastOf[axis] < 0.0f;
            shortest[axis] = backward ? -most[3 + axis] : least[3 + axis];
            longest[axis] = backward ? -least[3 + axis] : most[3 + axis];
            nearOrigin[axis] = backward ? least[axis] : most[axis];
            farOrigin[axis] = backward ? most[axis] : least[axis];
            leastInverse[axis] = leastOf[axis];
            mostInverse[axis] = mostOf[axis];
        }
        const float along = shortest[axes.kz];
        if (!(longest[axes.kx] < along && longest[axes.ky] < along)) return false;
        if (powerOfTwoBelow(longest[axes.kz]) != powerOfTwoBelow(along)) return false;
        rows = PlaneRows(rays);
        firstRay = first;
        isSheared = false;
        tMin = leastOf[7];
        scale = prepared->scale;
        bound = scaledTMax(most[7], scale);
        return true;
    }

    /// Which children of a node any of the rays may meet; lowers `nearest` to where.
    RAYSCOPE_INLINE unsigned intersects(const WideNode& node, Lanes& nearest) const {
        Lanes enter, leave;
        for (int axis = 0; axis < 3; ++axis) {
            const Lanes least = Lanes::broadcast(leastInverse[axis]),
                        most = Lanes::broadcast(mostInverse[axis]);
            const Lanes toNear = rows.nearPlanes(node, axis) - Lanes::broadcast(nearOrigin[axis]);
            const Lanes toFar = rows.farPlanes(node, axis) - Lanes::broadcast(farOrigin[axis]);
            const Lanes near = minimum(toNear * least, toNear * most),
                        far = maximum(toFar * least, toFar * most);
            enter = axis == 0 ? near : maximum(near, enter);
            leave = axis == 0 ? far : minimum(far, leave);
        }
        enter = maximum(padNear(enter), Lanes::broadcast(tMin));
        return lessOrEqual(enter, minimum(padFar(leave), Lanes::broadcast(bound)), enter, nearest);
    }

    /// Which of eight rays may meet a child of a node before their bounds.
    RAYSCOPE_INLINE unsigned intersects(const WideNode& node, int child, uint32_t group,
                                        const float* bounds) const {
        const RayColumns& ray = columns[group];
        Lanes enter, leave;
        for (int axis = 0; axis < 3; ++axis) {
            const Lanes origin = Lanes::load(ray.origin[axis]), inverse = Lanes::load(ray.inverse[axis]);
            const Lanes near = (Lanes::broadcast(node.planes[rows.near[axis]][child]) - origin) * inverse;
            const Lanes far = (Lanes::broadcast(node.planes[rows.near[axis] ^ 1][child]) - origin) * inverse;
            enter = axis == 0 ? near : maximum(near, enter);
            leave = axis == 0 ? far : minimum(far, leave);
        }
        return lessOrEqual(maximum(padNear(enter), Lanes::load(ray.tMin)),
                           minimum(padFar(leave), Lanes::load(bounds)));
    }

    /// The rays of a group, prepared for triangles.
    RAYSCOPE_INLINE const RayColumns& sheared(uint32_t group) {
        if (!isSheared) {
            isSheared = true;
            for (RayColumns& rays : columns) rays.shear(axes, scale);
        }
        return columns[group];
    }
};

}  // namespace
}  // namespace rayscope::bvh::kernel
