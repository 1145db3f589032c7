#pragma once
#include <rayscope/accel.h>
#include <span>

#include "bvh/layout/wide_tree.h"

namespace rayscope::bvh {

/// The work of traversals, summed over rays.
struct TraversalCounts {
    std::uint64_t nodes = 0;       ///< inner nodes visited
    std::uint64_t leaves = 0;      ///< leaves visited; in the wide tree blocks of triangles and spheres
    std::uint64_t primitives = 0;  ///< tested; in the wide tree all of a visited block
    std::uint64_t exact = 0;       ///< of them, those that the float test of a block leaves for the exact one

    TraversalCounts& operator+=(const TraversalCounts& other);
};

/// Adds the work of one query to `counts`; returns whether there is a hit. The ray need not be traceable.
///
/// The wide tree is traversed by the portable kernel, ray by ray, so the counts are the same on every
/// machine. Other instruction sets round the margins of boxes differently and may visit a few nodes more or
/// less.
bool countTraversal(const WideTree& tree, const Ray& ray, bool any, TraversalCounts& counts);
bool countTraversal(const BinaryTree& tree, const AccelInput& input, const Ray& ray, bool any,
                    TraversalCounts& counts);

/// Over the tree that the queries of `accel` traverse: the wide one, or with BvhLayout::Binary the binary
/// one.
bool countTraversal(const Accel& accel, const Ray& ray, bool any, TraversalCounts& counts);

/// The work of many queries, in parallel.
TraversalCounts countTraversals(const WideTree& tree, std::span<const Ray> rays, bool any);

}  // namespace rayscope::bvh
