// A ray against the boxes of a node. Include after one of the lanes_*.inl.
#include "bvh/kernel/fast_ray.h"
#include "bvh/kernel/hit_acceptance.h"
#include "bvh/kernel/wide_layout.h"

namespace rayscope::bvh::kernel {
namespace {

/// Rows of WideNode::planes, by the direction of a ray.
struct PlaneRows {
    int near[3];

    PlaneRows() = default;
    RAYSCOPE_INLINE explicit PlaneRows(RayData ray) {
        for (int axis = 0; axis < 3; ++axis)
            near[axis] = 2 * axis + static_cast<int>(__builtin_bit_cast(uint32_t, ray[3 + axis]) >> 31);
    }
    RAYSCOPE_INLINE Lanes nearPlanes(const WideNode& node, int axis) const {
        return Lanes::load(node.planes[near[axis]]);
    }
    RAYSCOPE_INLINE Lanes farPlanes(const WideNode& node, int axis) const {
        return Lanes::load(node.planes[near[axis] ^ 1]);
    }
};

/// The ray in all lanes, in the arithmetic of intersectBox().
struct ExactBoxLanes {
    PlaneRows rows;
    Lanes origin[3], nearInverse[3], farInverse[3], tMin;

    RAYSCOPE_INLINE ExactBoxLanes(RayData data, const BoxRay& ray)
        : rows(data), tMin(Lanes::broadcast(ray.tMin)) {
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = Lanes::broadcast(ray.origin[axis]);
            nearInverse[axis] = Lanes::broadcast(ray.nearInverse[axis]);
            farInverse[axis] = Lanes::broadcast(ray.farInverse[axis]);
        }
    }
    RAYSCOPE_INLINE Lanes near(const WideNode& node, int axis) const {
        return (rows.nearPlanes(node, axis) - origin[axis]) * nearInverse[axis];
    }
    RAYSCOPE_INLINE Lanes far(const WideNode& node, int axis) const {
        return (rows.farPlanes(node, axis) - origin[axis]) * farInverse[axis];
    }
};

/// The same in the arithmetic of FastRay, with its margins included in reciprocals and constants.
struct FastBoxLanes {
    PlaneRows rows;
    Lanes nearInverse[3], nearConstant[3], farInverse[3], farConstant[3], tMin;

    RAYSCOPE_INLINE FastBoxLanes(RayData data, const FastRay& ray)
        : rows(data), tMin(Lanes::broadcast(ray.tMin)) {
        constexpr float kShorter = 1.0f - 0x1p-20f, kLonger = 1.0f + 0x1p-20f;
        const Float4 pad = kernel::absolute(ray.constant) * 0x1p-21f + 0x1p-120f;
        const Float4 inverse[2] = {ray.inverse * kShorter, ray.inverse * kLonger};
        const Float4 constant[2] = {ray.constant * kShorter - pad, ray.constant * kLonger + pad};
        for (int axis = 0; axis < 3; ++axis) {
            nearInverse[axis] = Lanes::broadcast(inverse[0][axis]);
            farInverse[axis] = Lanes::broadcast(inverse[1][axis]);
            nearConstant[axis] = Lanes::broadcast(constant[0][axis]);
            farConstant[axis] = Lanes::broadcast(constant[1][axis]);
        }
    }
    RAYSCOPE_INLINE Lanes near(const WideNode& node, int axis) const {
        return multiplyAdd(rows.nearPlanes(node, axis), nearInverse[axis], nearConstant[axis]);
    }
    RAYSCOPE_INLINE Lanes far(const WideNode& node, int axis) const {
        return multiplyAdd(rows.farPlanes(node, axis), farInverse[axis], farConstant[axis]);
    }
};

/// Which children the ray intersects between tMin and `bound`: at least those that intersectBox() would find.
/// A NaN distance excludes nothing; an entry is never NaN, because maximum() returns tMin then.
template <class BoxLanes>
RAYSCOPE_INLINE unsigned intersectChildren(const WideNode& node, const BoxLanes& ray, float bound,
                                           Lanes& entry) {
    entry = maximum(maximum(ray.near(node, 0), ray.near(node, 1)), maximum(ray.near(node, 2), ray.tMin));
    const Lanes leave = minimum(minimum(ray.far(node, 0), ray.far(node, 1)),
                                minimum(ray.far(node, 2), Lanes::broadcast(bound)));
    return lessOrEqual(entry, leave);
}

}  // namespace
}  // namespace rayscope::bvh::kernel
