#pragma once
// A binary tree whose subtrees can be moved.
#include <stop_token>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"

namespace rayscope::bvh {

/// Nodes keep their numbers when they are moved, and boxes always are those of what lies below.
class LinkedTree {
  public:
    struct Node {
        float lower[3];
        std::uint32_t left;  ///< kNoNode: a leaf, with the primitives of the node of that number in `source`
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

    /// Takes `node` out of its place and makes it the sibling of `target`, if the areas of all inner nodes
    /// then sum up to less and no node gets below `deepestLevel`. Otherwise changes nothing. Returns how much
    /// the sum fell, or 0. Leaves of several primitives never get a smaller level: they are what builders
    /// make of a range that has reached the deepest level.
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
    std::vector<std::uint8_t> mayMoveUp_;     ///< no leaf of several primitives lies there or below
    std::uint32_t root_ = 0;
    float scale_;
};

}  // namespace rayscope::bvh
