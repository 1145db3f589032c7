#pragma once
#include <rayscope/accel.h>
#include <vector>

#include "bvh/builders/linked_tree.h"

namespace rayscope::bvh {

/// The subtrees of a linked tree that become leaves so that the SAH cost is least: those with at most
/// `leafSize` primitives whose cost as a leaf is not higher.
class LeafPlan {
  public:
    LeafPlan(const LinkedTree& tree, const BinaryTree& source, const BuildSettings& settings);

    /// SAH cost times the area of the root's box.
    float cost() const { return plans_[tree_.root()].cost; }

    /// The tree with these leaves, in the order that TreeSkeleton::compact() gives it.
    BinaryTree make() const;

  private:
    struct Plan {
        float cost = 0.0f;
        std::uint32_t primitives = 0;
        std::uint32_t nodes = 1;  ///< 1: a leaf
    };
    const Plan& plan(std::uint32_t number);
    void place(BinaryTree& result, std::uint32_t number, std::size_t at, int level) const;
    void placePrimitives(BinaryTree& result, std::uint32_t number) const;

    const LinkedTree& tree_;
    const BinaryTree& source_;
    const BuildSettings& settings_;
    base::BigVector<Plan> plans_;
};

}  // namespace rayscope::bvh
