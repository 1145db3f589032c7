#pragma once
// Where builders put their nodes while several threads work on one tree.
//
// A subtree over n primitives needs at most 2n − 1 nodes, so every subtree knows its place before it is
// built: the two children of a node come first, then everything below the left one, then everything below the
// right one. The places that stay empty are squeezed out at the end; the numbering does not depend on the
// threads.
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"

namespace rayscope {

/// A subtree to be built over the primitives in slots [begin, end).
struct Subtree {
    std::size_t begin, end;
    std::size_t node;   ///< place of its root
    std::size_t below;  ///< first of the 2 (end − begin) − 2 places for what hangs below the root
    int level;          ///< of its root

    std::size_t size() const { return end - begin; }
};

class TreeSkeleton {
  public:
    TreeSkeleton(std::size_t primitives, const BuildSettings& settings);

    Subtree whole() const { return {0, count_, 0, 1, 0}; }

    /// Makes the root of `tree` an inner node whose left child has the slots before `middle`.
    std::pair<Subtree, Subtree> split(const Subtree& tree, const Bounds4& box, std::size_t middle);

    /// Makes the root of `tree` a leaf. The caller fills the slots.
    void makeLeaf(const Subtree& tree, const Bounds4& box);
    std::uint32_t& slot(std::size_t index) { return primitives_[index]; }

    /// Whether the root of `tree` has to be a leaf whatever it would cost.
    bool mustBeLeaf(const Subtree& tree) const {
        return tree.size() == 1 || tree.level >= settings_.maxLevel;
    }

    /// Whether the subtree has to be halved from here on so that it ends above kMaxTreeLevel.
    static bool mustBeHalved(const Subtree& tree);

    const BuildSettings& settings() const { return settings_; }

    /// Squeezes out the empty places; the skeleton is used up.
    BinaryTree compact();

  private:
    class Compaction;

    std::size_t count_;
    BuildSettings settings_;
    BigVector<BinaryNode> nodes_;
    BigVector<std::uint32_t> primitives_;
};

}  // namespace rayscope
