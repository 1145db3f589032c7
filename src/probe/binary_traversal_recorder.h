#pragma once
#include <limits>
#include <unordered_map>

#include "bvh/traversal/traverse.h"
#include "probe/traversal_log.h"

namespace rayscope::probe {

/// Writes down a walk through a binary tree.
class BinaryTraversalRecorder {
  public:
    BinaryTraversalRecorder(TraversalLog& log, const bvh::BinaryTree& tree, const AccelInput& input)
        : log_(log), tree_(tree), input_(input), query_(log.ray), bound_(log.ray.tMax) {}

    // What an observer of closestHit() is told. A far child that has to wait is not reported by the walk: it
    // is the one that was neither rejected nor entered at once.
    void visit(std::uint32_t node, float bound) {
        if (const std::uint32_t sibling = pushedSiblingOf(node); sibling != kNone) push(sibling);
        bound_ = bound;
        add(TraversalEvent::Visited, boxOf(node), entryOf(node), bound);
        lastVisited_ = static_cast<int>(boxOf(node));
        children_ = tree_.nodes[node].isLeaf() || log_.anyHit ? kNone : tree_.nodes[node].first;
        culledChildren_ = 0;
    }
    void cull(std::uint32_t node, float bound) {
        add(TraversalEvent::Culled, boxOf(node), entryOf(node), bound);
        ++culledChildren_;
    }
    void miss(std::uint32_t node) {
        add(TraversalEvent::Missed, boxOf(node), kNoDistance, bound_);
        ++culledChildren_;
    }
    void test(std::uint32_t primitive, bool hit) {
        Hit found;
        if (hit) bvh::IndexedPrimitives::hitsPrimitive(query_, input_, primitive, bound_, found);
        found.primitive = primitive;
        Hit best{bound_, closest_, 0.0f, 0.0f};
        const bool closer = hit && bvh::keepCloser(found, best);
        add(closer ? TraversalEvent::Hit : TraversalEvent::NoHit, primitive, hit ? found.t : kNoDistance,
            bound_);
        if (!closer) return;
        bound_ = found.t;
        closest_ = primitive;
    }

    /// The search for any hit says itself what waits.
    void push(std::uint32_t node) { add(TraversalEvent::Pushed, boxOf(node), entryOf(node), bound_); }

  private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr float kNoDistance = std::numeric_limits<float>::quiet_NaN();

    /// The other child of the node that was entered last, if `node` is one of its children and none was
    /// rejected.
    std::uint32_t pushedSiblingOf(std::uint32_t node) const {
        if (children_ == kNone || culledChildren_ > 0) return kNone;
        return node == children_ ? children_ + 1 : node == children_ + 1 ? children_ : kNone;
    }
    float entryOf(std::uint32_t node) const {
        float entry;
        if (!bvh::intersectBox(bvh::planes(tree_.nodes[node]), query_.box, query_.box.tMax, entry))
            return kNoDistance;
        return static_cast<float>(entry / query_.box.scale);
    }
    /// A new box is the root or a child of the node that was entered last.
    std::uint32_t boxOf(std::uint32_t node) {
        const auto [known, isNew] = known_.try_emplace(node, static_cast<std::uint32_t>(log_.boxes.size()));
        if (isNew) {
            const bvh::BinaryNode& n = tree_.nodes[node];
            log_.boxes.push_back({node, lastVisited_, n.isLeaf(), n.lower, n.upper});
        }
        return known->second;
    }
    void add(TraversalEvent event, std::uint32_t number, float t, float bound) {
        log_.steps.push_back({event, number, t, bound});
    }

    TraversalLog& log_;
    const bvh::BinaryTree& tree_;
    const AccelInput& input_;
    bvh::RayQuery query_;
    std::unordered_map<std::uint32_t, std::uint32_t> known_;  ///< node → box
    float bound_;
    std::uint32_t closest_ = kNoPrimitive;
    int lastVisited_ = -1;            ///< box
    std::uint32_t children_ = kNone;  ///< first child of the node that was entered last, if it has any
    int culledChildren_ = 0;          ///< of these children
};
static_assert(bvh::TraversalObserver<BinaryTraversalRecorder>);

}  // namespace rayscope::probe
