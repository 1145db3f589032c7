#pragma once
// Selects the nodes of the binary tree that become nodes and leaves of the wide one.
#include <rayscope/accel.h>
#include <array>

#include "bvh/binary_tree.h"

namespace rayscope::bvh {

/// Size of a subtree of the wide tree.
struct WideTreeSize {
    std::uint32_t nodes, blocks, spheres;
    WideTreeSize operator+(const WideTreeSize& other) const {
        return {nodes + other.nodes, blocks + other.blocks, spheres + other.spheres};
    }
};

/// The cheapest collapse of a binary tree to nodes of eight, by dynamic programming from the leaves up
/// (Ylitie, Karras, Laine 2017, §3): for every binary node, and every number i of child slots of a wide node
/// that it may use, the distribution of these slots to its two children.
class CollapsePlan {
  public:
    CollapsePlan(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop);

    /// Whether a node becomes a leaf of the wide tree.
    bool isLeaf(std::uint32_t node) const { return plans_[node].leftSlots[0] == 0; }

    /// The size of the subtree that a node becomes.
    const WideTreeSize& countOf(std::uint32_t node) const { return plans_[node].count; }

    /// The children of the wide node that a node becomes.
    struct Children {
        std::array<std::uint32_t, 8> node;
        int count = 0;
    };
    Children childrenOf(std::uint32_t node) const;

  private:
    struct Plan {
        /// At index i − 1, the number of i slots for the left child; 0: i − 1 slots are enough. At index 0,
        /// of the eight slots of the wide node that the node becomes; 0: it is a leaf.
        std::array<std::uint8_t, 8> leftSlots;
        WideTreeSize count;
    };
    struct Options;
    Options plan(std::uint32_t node, int level);
    Options planLeaf(std::uint32_t node);
    void take(std::uint32_t node, std::uint8_t slots, Children& children) const;

    const BinaryTree& tree_;
    const AccelInput& input_;
    const std::stop_token& stop_;
    base::BigVector<Plan> plans_;
    int parallelLevels_;  ///< children of nodes above this level are planned in parallel
};

/// The number of triangles of a leaf.
std::uint32_t trianglesIn(const BinaryTree& tree, const AccelInput& input, const BinaryNode& leaf);

/// The size of a binary leaf as a subtree over its blocks and spheres in order.
WideTreeSize countOfLeaf(std::uint32_t triangles, std::uint32_t spheres);

}  // namespace rayscope::bvh
