#pragma once
// Which nodes of the binary tree become the nodes and leaves of the wide one.
#include <rayscope/accel.h>
#include <array>

#include "bvh/binary_tree.h"

namespace rayscope::bvh {

/// What a subtree of the binary tree needs in the wide one.
struct WideTreeSize {
    std::uint32_t nodes, blocks, spheres;
    WideTreeSize operator+(const WideTreeSize& other) const {
        return {nodes + other.nodes, blocks + other.blocks, spheres + other.spheres};
    }
};

/// The cheapest way to gather a binary tree into nodes of eight, by dynamic programming from the leaves up
/// (Ylitie, Karras, Laine 2017, §3): for every binary node, and every number of places i that it may take
/// among the children of a wide node, how the places are shared between its two children.
class CollapsePlan {
  public:
    CollapsePlan(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop);

    /// Whether a node, being a child of a wide node, is a leaf there.
    bool isLeaf(std::uint32_t node) const { return plans_[node].leftPlaces[0] == 0; }

    /// What a node needs as a child of a wide node, with all that is below.
    const WideTreeSize& countOf(std::uint32_t node) const { return plans_[node].count; }

    /// The children of the wide node that a node becomes.
    struct Children {
        std::array<std::uint32_t, 8> node;
        int count = 0;
    };
    Children childrenOf(std::uint32_t node) const;

  private:
    struct Plan {
        /// At index i − 1, how many of i places the left child gets; 0: i − 1 places are enough. At index 0,
        /// of the eight places of the node's own children; 0: it is a leaf.
        std::array<std::uint8_t, 8> leftPlaces;
        WideTreeSize count;
    };
    struct Options;
    Options plan(std::uint32_t node, int level);
    Options planLeaf(std::uint32_t node);
    void take(std::uint32_t node, std::uint8_t places, Children& children) const;

    const BinaryTree& tree_;
    const AccelInput& input_;
    const std::stop_token& stop_;
    base::BigVector<Plan> plans_;
    int parallelLevels_;  ///< nodes above this level hand their children to different threads
};

/// How many of a leaf's primitives are triangles.
std::uint32_t trianglesIn(const BinaryTree& tree, const AccelInput& input, const BinaryNode& leaf);

/// What a binary leaf needs that holds more than one block: a hierarchy over its blocks and spheres in order.
WideTreeSize countOfLeaf(std::uint32_t triangles, std::uint32_t spheres);

}  // namespace rayscope::bvh
