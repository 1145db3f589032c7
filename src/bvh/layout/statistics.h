#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/binary_tree.h"

namespace rayscope::bvh {

/// SAH cost model: visiting an inner node costs as much as testing a primitive.
inline constexpr double kTraversalCost = 1.0;
inline constexpr double kIntersectionCost = 1.0;

struct TreeStatistics {
    /// Expected cost of a random line that intersects the root's box: the sum over all nodes of the area of
    /// their box relative to the root's, times kTraversalCost for inner nodes and kIntersectionCost per
    /// primitive for leaves (Goldsmith, Salmon 1987). If the root has no area, every relative area counts
    /// as 1.
    double sahCost = 0.0;
    std::size_t nodes = 0;
    std::size_t leaves = 0;
    std::size_t primitives = 0;
    std::size_t bytes = 0;                   ///< of nodes and primitive numbers
    int levels = 0;                          ///< including the root
    std::vector<std::size_t> leavesAtLevel;  ///< index: level, the root is 0
    std::vector<std::size_t> leavesOfSize;   ///< index: number of primitives
};

TreeStatistics statisticsOf(const BinaryTree& tree);

/// Half the surface area of a node's box.
double halfArea(const BinaryNode& node);

}  // namespace rayscope::bvh
