#pragma once
#include <limits>
#include <unordered_map>
#include <vector>

#include "bvh/traversal/traverse.h"
#include "probe/traversal_log.h"

namespace rayscope::probe {

/// Records a traversal of a binary tree.
class BinaryTraversalRecorder : public bvh::NullTraversalObserver {
  public:
    BinaryTraversalRecorder(TraversalLog& log, const bvh::BinaryTree& tree) : log_(log), tree_(tree) {}

    void intersect(std::uint32_t node, float entry) { entries_[boxOf(node)] = entry; }
    void miss(std::uint32_t node, float bound) { addBox(TraversalEvent::Missed, node, bound); }
    void cull(std::uint32_t node, float bound) { addBox(TraversalEvent::Culled, node, bound); }
    void push(std::uint32_t node, float bound) { addBox(TraversalEvent::Pushed, node, bound); }
    void visit(std::uint32_t node, float bound) {
        addBox(TraversalEvent::Visited, node, bound);
        visited_ = static_cast<int>(boxOf(node));
    }
    void test(std::uint32_t primitive, bool isHit, const bvh::kernel::HitData& hit, float bound) {
        Hit best{bound, closest_, 0.0f, 0.0f};
        const bool isCloser = isHit && bvh::keepCloser({hit.t, primitive, hit.u, hit.v}, best);
        log_.steps.push_back({isCloser ? TraversalEvent::Hit : TraversalEvent::NoHit, primitive,
                              isHit ? hit.t : kNoDistance, bound});
        if (isCloser) closest_ = primitive;
    }

  private:
    static constexpr float kNoDistance = std::numeric_limits<float>::quiet_NaN();

    /// A new box is the root or a child of the node that was visited last.
    std::uint32_t boxOf(std::uint32_t node) {
        const auto [known, isNew] = known_.try_emplace(node, static_cast<std::uint32_t>(log_.boxes.size()));
        if (isNew) {
            const bvh::BinaryNode& n = tree_.nodes[node];
            log_.boxes.push_back({node, visited_, n.isLeaf(), n.lower, n.upper});
            entries_.push_back(kNoDistance);
        }
        return known->second;
    }
    void addBox(TraversalEvent event, std::uint32_t node, float bound) {
        const std::uint32_t box = boxOf(node);
        log_.steps.push_back({event, box, entries_[box], bound});
    }

    TraversalLog& log_;
    const bvh::BinaryTree& tree_;
    std::unordered_map<std::uint32_t, std::uint32_t> known_;  ///< node → box
    std::vector<float> entries_;                              ///< of boxes; NaN where missed
    std::uint32_t closest_ = kNoPrimitive;
    int visited_ = -1;  ///< box of the node visited last
};
static_assert(bvh::TraversalObserver<BinaryTraversalRecorder>);

}  // namespace rayscope::probe
