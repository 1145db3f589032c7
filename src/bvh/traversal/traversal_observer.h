#pragma once
#include <concepts>
#include <cstdint>

namespace rayscope::bvh {

/// What can be watched while a ray walks the binary tree. Node numbers index BinaryTree::nodes.
template <class O>
concept TraversalObserver = requires(O& o, std::uint32_t node, std::uint32_t primitive, float t, bool hit) {
    o.visit(node, t);        ///< the box was hit and is searched now; t is the running bound
    o.cull(node, t);         ///< the box was hit, but lies behind the closest hit found since
    o.miss(node);            ///< the box was tested and not hit
    o.test(primitive, hit);  ///< a primitive of a leaf was tested
};

struct NullTraversalObserver {
    static void visit(std::uint32_t, float) {}
    static void cull(std::uint32_t, float) {}
    static void miss(std::uint32_t) {}
    static void test(std::uint32_t, bool) {}
};

}  // namespace rayscope::bvh
