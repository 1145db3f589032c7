#pragma once
// The events of a traversal, for the binary tree (traversal/traverse.h) and the wide one (traverse_wide.inl).
#include "bvh/kernel/hit_acceptance.h"

namespace rayscope::bvh {

/// Receives the events of one traversal. `node` is an index into BinaryTree::nodes, or a kernel::ChildRef of
/// the wide tree, where blocks and spheres are nodes too; `primitive` is as in Hit::primitive. Distances are
/// in units of the ray's direction; `bound` is the traversal bound before the event, which is tMax until
/// there is a hit. Observers that need only some of the events inherit the others from NullTraversalObserver.
template <class O>
concept TraversalObserver = requires(O& o, uint32_t node, uint32_t primitive, float entry, float bound,
                                     bool isHit, const kernel::HitData& hit) {
    // Boxes. The box of a node is hit (first at `entry`, before the node is culled, pushed or visited) or
    // missed.
    o.intersect(node, entry);
    o.miss(node, bound);
    // Nodes: dropped because the box begins behind the closest hit; put on the stack; children or primitives
    // are tested now.
    o.cull(node, bound);
    o.push(node, bound);
    o.visit(node, bound);
    // Primitives: tested exactly, where `hit` is valid if isHit. In the wide tree the float test of a block
    // may exclude a hit before, or in a query for any hit make the exact test unnecessary.
    o.test(primitive, isHit, hit, bound);
    o.filter(primitive, bound);
    o.certainHit(primitive, hit, bound);
};

struct NullTraversalObserver {
    static void intersect(uint32_t, float) {}
    static void miss(uint32_t, float) {}
    static void cull(uint32_t, float) {}
    static void push(uint32_t, float) {}
    static void visit(uint32_t, float) {}
    static void test(uint32_t, bool, const kernel::HitData&, float) {}
    static void filter(uint32_t, float) {}
    static void certainHit(uint32_t, const kernel::HitData&, float) {}
};

/// False for NullTraversalObserver: what only observers need is then not computed.
template <class O>
constexpr bool isObserved = true;
template <class O>
constexpr bool isObserved<O&> = isObserved<O>;
template <>
constexpr bool isObserved<NullTraversalObserver> = false;

}  // namespace rayscope::bvh
