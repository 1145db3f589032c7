#pragma once
// The nodes of a tree while it is built by several threads.
//
// Every thread fills chunks of nodes of its own, without contention, and memory is touched only where there
// are nodes. At the end the nodes are sorted depth first, so the numbering does not depend on the threads.
#include <rayscope/accel.h>
#include <atomic>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"

namespace rayscope::bvh {

/// A subtree to be built over the primitives in slots [begin, end).
struct Subtree {
    std::size_t begin, end;
    std::size_t node;  ///< index of its root
    int level;         ///< of its root

    std::size_t size() const { return end - begin; }
};

class TreeSkeleton {
  public:
    TreeSkeleton(std::size_t primitives, const BuildSettings& settings);

    Subtree whole() const { return {0, count_, 0, 0}; }

    /// Makes the root of `tree` an inner node; the left child has the slots before `middle`.
    std::pair<Subtree, Subtree> split(const Subtree& tree, const Bounds4& box, std::size_t middle);

    /// Makes the root of `tree` a leaf. The caller fills the slots.
    void makeLeaf(const Subtree& tree, const Bounds4& box);
    std::uint32_t& slot(std::size_t index) { return primitives_[index]; }

    /// Whether the root of `tree` is a leaf at any cost.
    bool mustBeLeaf(const Subtree& tree) const {
        return tree.size() == 1 || tree.level >= settings_.maxLevel;
    }

    /// Whether only median splits from here on keep the subtree within kMaxTreeLevel.
    static bool mustSplitAtMedian(const Subtree& tree);

    const BuildSettings& settings() const { return settings_; }

    /// Sorts the nodes. The skeleton is empty afterwards.
    BinaryTree compact();

  private:
    class Compaction;

    /// Nodes that one thread fills.
    struct alignas(64) NodeChunk {
        std::size_t next = 0, end = 0;
    };
    std::size_t allocatePair();

    std::size_t count_;
    BuildSettings settings_;
    std::vector<NodeChunk> chunks_;       ///< one per thread
    std::atomic<std::size_t> allocated_;  ///< nodes in chunks, and the root
    base::BigVector<BinaryNode> nodes_;
    base::BigVector<std::uint32_t> primitives_;
};

}  // namespace rayscope::bvh
