#pragma once
// A binary tree whose subtrees can be moved.
#include <stop_token>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"

namespace rayscope::bvh {

/// Nodes keep their numbers when they are moved; boxes are always up to date.
class LinkedTree {
  public:
    struct Node {
        float lower[3];
        std::uint32_t left;  ///< kNoNode: a leaf, with the primitives of the same node of `source`
        float upper[3];
        std::uint32_t right;

        bool isLeaf() const { return left == kNoNode; }
        Bounds4 box() const;
        void setBox(const Bounds4& box);
    };

    /// A copy of `source`, which must not be empty, with the same numbers. Areas are scaled by scale².
    LinkedTree(const BinaryTree& source, float scale, const std::stop_token& stop);

    std::size_t size() const { return nodes_.size(); }
    std::uint32_t root() const { return root_; }
    const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    std::uint32_t parent(std::uint32_t node) const { return parents_[node]; }
    std::uint32_t sibling(std::uint32_t node) const {
        const Node& parent = nodes_[parents_[node]];
        return parent.left == node ? parent.right : parent.left;
    }
    float scale() const { return scale_; }

    /// Makes `node` the sibling of `target`, if that reduces the total area of the inner nodes and no node
    /// gets below `deepestLevel`; otherwise changes nothing. Returns the reduction, or 0. Leaves of several
    /// primitives are never moved up: they are ranges that reached the deepest level.
    double moveIfBetter(std::uint32_t node, std::uint32_t target, int deepestLevel);

  private:
    void copyNode(const BinaryTree& source, std::uint32_t node);
    void replaceChild(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
    double detach(std::uint32_t node);
    double attach(std::uint32_t node, std::uint32_t parent, std::uint32_t target);
    double refitFrom(std::uint32_t node);
    int levelOutside(std::uint32_t node, std::uint32_t subtree) const;
    double area(const Bounds4& box) const { return static_cast<double>(box.halfArea(scale_)); }

    base::BigVector<Node> nodes_;
    base::BigVector<std::uint32_t> parents_;  ///< kNoNode: the root
    std::vector<std::uint8_t> heights_;       ///< levels below the node
    std::vector<std::uint8_t> mayMoveUp_;     ///< the subtree has no leaf of several primitives
    std::uint32_t root_ = 0;
    float scale_;
};

}  // namespace rayscope::bvh
