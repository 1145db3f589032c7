// All hits of one ray with the wide tree. Include after one of the lanes_*.inl.
#include "bvh/kernel/kernels.h"
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::bvh::kernel {
namespace {

/// Passes all hits with the primitives of a leaf to `sink`.
RAYSCOPE_INLINE void visitLeafForAll(const WideTreeView& tree, FastShear& shear, ChildRef leaf,
                                     const QueryState& state, CrossingSink sink) {
    if (leaf >= kSphereTag) {
        const SphereRecord& record = tree.spheres[leaf & kSphereIndexMask];
        HitData found[2];
        const int count = crossSphere(state.ray, record.sphere, state.best.t, found);
        for (int i = 0; i < count; ++i) {
            found[i].primitive = record.primitive;
            sink.add(sink.to, found[i]);
        }
        return;
    }
    shear.prepareOnce(state.ray, static_cast<float>(state.scale));
    const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
    unsigned possible = filterTriangles(block, leaf, shear, state.tMin, state.bound).possible;
    if (possible == 0) return;
    const BlockRay ray(state.ray, shear);
    for (; possible != 0; possible &= possible - 1) {
        HitData found;
        if (ray.hits(block, __builtin_ctz(possible), state.best.t, found)) sink.add(sink.to, found);
    }
}

/// Children in any order. A loop of its own beside traverseAny(), which takes 9 % more instructions as an
/// instance of a common one.
template <class BoxLanes>
RAYSCOPE_INLINE void traverseAll(const WideTreeView& tree, const BoxLanes& lanes, const QueryState& state,
                                 CrossingSink sink) {
    ChildRef stack[kStackSize];
    stack[0] = tree.root;
    FastShear shear{};
    for (int stackSize = 1; stackSize > 0;) {
        const ChildRef ref = stack[--stackSize];
        if (ref & kTagMask) {
            visitLeafForAll(tree, shear, ref, state, sink);
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, state.bound, entry);
            stackSize += static_cast<int>(compress(mask, node.child, stack + stackSize));
        }
    }
}

void crossings(const WideTreeView& tree, RayData ray, CrossingSink sink) {
    if (!isTraceable(ray)) return;
    withPreparedRay(tree, ray, [&](const auto& lanes, const QueryState& state) {
        traverseAll(tree, lanes, state, sink);
    });
}

}  // namespace
}  // namespace rayscope::bvh::kernel
