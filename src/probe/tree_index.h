#pragma once
// What one wants to know of the nodes of a tree, and the tree itself does not store because rays never ask.
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/binary_tree.h"

namespace rayscope::probe {

/// Facts about all nodes of a tree; every vector but `leaves` is indexed by node.
struct TreeIndex {
    std::vector<std::uint32_t> parent;      ///< kNoNode for the root
    std::vector<std::uint8_t> level;        ///< 0 for the root
    std::vector<std::uint32_t> primitives;  ///< in all leaves below the node
    /// Expected cost for a line that meets the node's box, in the cost model of statisticsOf(); for the root
    /// it is the SAH cost of the tree.
    std::vector<double> cost;
    std::vector<std::uint32_t> leaves;  ///< in preorder, left before right

    /// The place of a leaf among `leaves`; their number if `node` is none of them.
    std::size_t leafNumber(std::uint32_t node) const;
};

TreeIndex indexTree(const bvh::BinaryTree& tree);

/// The nodes of one level, in preorder. With `leavesAbove` the leaves that end higher up, too: together the
/// boxes then hold every primitive.
std::vector<std::uint32_t> nodesAtLevel(const bvh::BinaryTree& tree, const TreeIndex& index, int level,
                                        bool leavesAbove);

/// The primitives of a leaf, as in Hit::primitive; none for an inner node.
std::span<const std::uint32_t> primitivesOfLeaf(const bvh::BinaryTree& tree, std::uint32_t node);

/// How much the boxes of a node's two children overlap: half the area of what they share, relative to the
/// node's. 0 for leaves and where nothing is shared; a line that meets the node enters both children at least
/// this often.
double childOverlap(const bvh::BinaryTree& tree, std::uint32_t node);

/// Two trees over the same primitives, seen at one level.
struct LevelComparison {
    std::size_t boxes[2] = {0, 0};
    /// Expected number of these boxes that a line through the root's box meets: the sum of their areas
    /// relative to the root's.
    double met[2] = {0.0, 0.0};
    double sahCost[2] = {0.0, 0.0};  ///< of the whole trees
};
LevelComparison compareAtLevel(const bvh::BinaryTree& a, const TreeIndex& indexA, const bvh::BinaryTree& b,
                               const TreeIndex& indexB, int level);

}  // namespace rayscope::probe
