#pragma once
// Properties of the nodes of a binary tree that traversals do not need and the tree does not store.
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/binary_tree.h"

namespace rayscope::probe {

/// All vectors except `leaves` are indexed by node.
struct TreeIndex {
    std::vector<std::uint32_t> parent;      ///< kNoNode for the root
    std::vector<std::uint8_t> level;        ///< 0 for the root
    std::vector<std::uint32_t> primitives;  ///< in all leaves below the node
    /// Expected cost of a line that intersects the box of the node, in the cost model of statisticsOf(); for
    /// the root the SAH cost of the tree.
    std::vector<double> cost;
    std::vector<std::uint32_t> leaves;  ///< in preorder, left before right

    /// The index of a leaf in `leaves`; their number if `node` is not one of them.
    std::size_t leafNumber(std::uint32_t node) const;
};

TreeIndex indexTree(const bvh::BinaryTree& tree);

/// The nodes of one level, in preorder; with `leavesAbove` also the leaves of the levels above, so that the
/// boxes contain every primitive.
std::vector<std::uint32_t> nodesAtLevel(const bvh::BinaryTree& tree, const TreeIndex& index, int level,
                                        bool leavesAbove);

/// The primitives of a leaf, as in Hit::primitive; none for an inner node.
std::span<const std::uint32_t> primitivesOfLeaf(const bvh::BinaryTree& tree, std::uint32_t node);

/// The overlap of the boxes of a node's two children: the area of their intersection relative to the area of
/// the node. 0 for leaves and disjoint children. A line that intersects the node intersects both children
/// with at least this probability.
double childOverlap(const bvh::BinaryTree& tree, std::uint32_t node);

/// One level of two trees over the same primitives.
struct LevelComparison {
    std::size_t boxes[2] = {0, 0};
    /// Expected number of these boxes that a line through the root's box intersects: the sum of their areas
    /// relative to the root's.
    double expectedHits[2] = {0.0, 0.0};
    double sahCost[2] = {0.0, 0.0};  ///< of the whole trees
};
LevelComparison compareAtLevel(const bvh::BinaryTree& a, const TreeIndex& indexA, const bvh::BinaryTree& b,
                               const TreeIndex& indexB, int level);

}  // namespace rayscope::probe
