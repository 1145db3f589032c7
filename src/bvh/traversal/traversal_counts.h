#pragma once
#include <rayscope/ray.h>
#include <span>

#include "bvh/layout/wide_tree.h"

namespace rayscope::bvh {

/// What searches of the wide tree do, summed over rays.
struct TraversalCounts {
    std::uint64_t nodes = 0;       ///< inner nodes whose children's boxes are tested
    std::uint64_t leaves = 0;      ///< blocks of triangles, or spheres
    std::uint64_t primitives = 0;  ///< in those leaves
    std::uint64_t exact = 0;       ///< of them, those that the filter leaves for the exact test
};

/// Counts with the kernels that any machine has, so the figures are the same everywhere. Other instruction
/// sets round the margins of boxes differently and may visit a few nodes more or less.
TraversalCounts countTraversals(const WideTree& tree, std::span<const Ray> rays, bool any);

}  // namespace rayscope::bvh
