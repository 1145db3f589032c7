#pragma once
// Where builders put their nodes while several threads work on one tree.
//
// Every thread takes places in pieces and fills them one after another, so that threads do not meet and
// memory is touched only where there are nodes. At the end the nodes are put in order, depth first; so the
// numbering does not depend on the threads.
#include <rayscope/accel.h>
#include <atomic>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"

namespace rayscope::bvh {

/// A subtree to be built over the primitives in slots [begin, end).
struct Subtree {
    std::size_t begin, end;
    std::size_t node;  ///< place of its root
    int level;         ///< of its root

    std::size_t size() const { return end - begin; }
};

class TreeSkeleton {
  public:
    TreeSkeleton(std::size_t primitives, const BuildSettings& settings);

    Subtree whole() const { return {0, count_, 0, 0}; }

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
    static bool mustSplitAtMedian(const Subtree& tree);

    const BuildSettings& settings() const { return settings_; }

    /// Puts the nodes in order; the skeleton is used up.
    BinaryTree compact();

  private:
    class Compaction;

    /// Places that one thread fills.
    struct alignas(64) NodeChunk {
        std::size_t next = 0, end = 0;
    };
    std::size_t allocatePair();

    std::size_t count_;
    BuildSettings settings_;
    std::vector<NodeChunk> chunks_;       ///< of the threads
    std::atomic<std::size_t> allocated_;  ///< places in pieces, and the root's
    base::BigVector<BinaryNode> nodes_;
    base::BigVector<std::uint32_t> primitives_;
};

}  // namespace rayscope::bvh
