#include "bvh/builders/reinsertion.h"

#include <utility>

namespace rayscope::bvh {
namespace {

/// Long thin boxes that overlap many others would visit tens of thousands of nodes, without better results.
constexpr int kMaxVisited = 256;

class ReinsertionSearch {
  public:
    ReinsertionSearch(const LinkedTree& tree, std::uint32_t node)
        : tree_(tree), box_(tree[node].box()), area_(areaOf(box_)), best_{node} {}

    Reinsertion run() {
        const std::uint32_t parent = tree_.parent(best_.node);
        if (parent == kNoNode) return best_;
        // The area saved up to `pivot` when the node is removed, and the box of the rest.
        float saved = areaOf(tree_[parent].box());
        const std::uint32_t sibling = tree_.sibling(best_.node);
        Bounds4 rest = tree_[sibling].box();
        searchBelow(sibling, saved);
        for (std::uint32_t pivot = parent; tree_.parent(pivot) != kNoNode; pivot = tree_.parent(pivot)) {
            const std::uint32_t other = tree_.sibling(pivot), above = tree_.parent(pivot);
            consider(other, saved, mergedArea(other));
            searchBelow(other, saved);
            const float area = areaOf(tree_[above].box());
            rest.extend(tree_[other].box());
            saved += area - areaOf(rest);
            consider(above, saved, area);
        }
        return best_;
    }

  private:
    float areaOf(const Bounds4& box) const { return box.halfArea(tree_.scale()); }

    /// Of a new parent of the node and `target`.
    float mergedArea(std::uint32_t target) const {
        Bounds4 merged = tree_[target].box();
        merged.extend(box_);
        return areaOf(merged);
    }

    void consider(std::uint32_t target, float saved, float merged) {
        if (saved - merged > best_.gain) best_ = {best_.node, target, saved - merged};
    }

    /// Tries all targets strictly below `top`; `saved` includes the growth of the boxes above it.
    void searchBelow(std::uint32_t top, float saved) {
        StackEntry stack[kMaxTreeLevel + 2];
        int stackSize = 0;
        const auto push = [&](std::uint32_t node, float savedAbove, float merged) {
            if (!tree_[node].isLeaf())
                stack[stackSize++] = {node, savedAbove - (merged - areaOf(tree_[node].box()))};
        };
        push(top, saved, mergedArea(top));
        while (stackSize > 0) {
            const StackEntry at = stack[--stackSize];
            // The box of the new parent is at least as large as the node.
            if (at.saved - area_ <= best_.gain) continue;
            if (++visited_ > kMaxVisited) return;
            std::uint32_t near = tree_[at.node].left, far = tree_[at.node].right;
            float nearMerged = mergedArea(near), farMerged = mergedArea(far);
            if (farMerged < nearMerged) {
                std::swap(near, far);
                std::swap(nearMerged, farMerged);
            }
            consider(near, at.saved, nearMerged);
            consider(far, at.saved, farMerged);
            push(far, at.saved, farMerged);
            push(near, at.saved, nearMerged);
        }
    }

    /// A node to visit, and the saved area minus the growth of all boxes down to its own.
    struct StackEntry {
        std::uint32_t node;
        float saved;
    };

    const LinkedTree& tree_;
    const Bounds4 box_;
    const float area_;
    Reinsertion best_;
    int visited_ = 0;
};

}  // namespace

Reinsertion bestReinsertion(const LinkedTree& tree, std::uint32_t node) {
    return ReinsertionSearch(tree, node).run();
}

}  // namespace rayscope::bvh
