// Packets of coherent rays. Include after one of the lanes_*.inl.
//
// A packet is sixteen rays with equal signs and equal longest component of their directions. A node is
// tested once for all of them, by interval arithmetic: the least and largest origins and reciprocals of
// directions bound the distances at which any of the rays is in a box (Boulos, Wald and Shirley
// 2006). At leaves every ray is tested, eight at a time against one triangle.
#include "bvh/kernel/single_rays.inl"

namespace rayscope::bvh::kernel {
namespace {

constexpr uint32_t kPacketSize = 16;
constexpr uint32_t kPacketGroups = kPacketSize / kWidth;  ///< of eight rays

/// Distances from one difference, one reciprocal and one product, padded as in the fast test of a single ray
/// (see FastRay) and by more than the rounding of denormal numbers.
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
    // Bounds over all rays, distances scaled:
    float nearOrigin[3], farOrigin[3];  ///< closest to and farthest from the planes ahead
    float leastInverse[3], mostInverse[3];
    float tMin, bound;

    /// Sets all bounds for sixteen rays whose columns are prepared. Returns false if they are not coherent.
    RAYSCOPE_INLINE bool gather(const float* rays, const PackedRay* prepared, uint32_t first) {
        Lanes leastData = Lanes::loadUnaligned(rays), mostData = leastData;
        Lanes leastFast = Lanes::loadUnaligned(prepared->inverse), mostFast = leastFast;
        for (uint32_t i = 1; i < kPacketSize; ++i) {
            const Lanes data = Lanes::loadUnaligned(rays + 8 * i);
            leastData = minimum(leastData, data);
            mostData = maximum(mostData, data);
            const Lanes fast = Lanes::loadUnaligned(prepared[i].inverse);
            leastFast = minimum(leastFast, fast);
            mostFast = maximum(mostFast, fast);
        }
        alignas(32) float least[8], most[8], leastOf[8], mostOf[8];
        leastData.store(least);
        mostData.store(most);
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

    /// The children of a node that any of the rays may hit; lowers `nearest` to their entries.
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

    /// Which of eight rays may hit a child of a node before their bounds.
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
