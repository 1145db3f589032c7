#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

#include "bvh/builders.h"
#include "bvh/stop_check.h"

namespace rayscope {
namespace {

constexpr std::size_t kParallelSize = 4096;

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    std::size_t middle = 0;  ///< relative to the first primitive of the builder
    std::size_t offCentre = 0;
    int axis = -1;

    /// Prefers the cheaper, of equal cost the more balanced split, so that equal boxes give a shallow tree.
    bool isBetterThan(const Split& other) const {
        return cost < other.cost || (cost == other.cost && offCentre < other.offCentre);
    }
};

/// Positions count from the first slot of the subtree given to the constructor.
class SweepBuilder {
  public:
    SweepBuilder(TreeSkeleton& skeleton, std::span<const PrimitiveRef> refs, std::size_t firstSlot,
                 float scale)
        : skeleton_(skeleton),
          stop_(skeleton.settings().stop),
          refs_(refs),
          firstSlot_(firstSlot),
          scale_(scale),
          onRight_(refs.size()) {
        for (int axis = 0; axis < 3; ++axis) {
            areas_[axis].resize(refs.size());
            scratch_[axis].resize(refs.size());
            sort(axis);
        }
    }

    void build(const Subtree& tree) {
        throwIfStopped(stop_);
        const std::size_t begin = tree.begin - firstSlot_, end = tree.end - firstSlot_;
        if (skeleton_.mustBeLeaf(tree)) return makeLeaf(tree, boxOf(begin, end));
        Bounds4 box;
        const Split split = bestSplit(tree, box);
        const float area = box.halfArea(scale_), count = static_cast<float>(tree.size());
        if (tree.size() <= static_cast<std::size_t>(skeleton_.settings().leafSize) &&
            count * kIntersectionCost * area <= kTraversalCost * area + kIntersectionCost * split.cost)
            return makeLeaf(tree, box);

        partition(begin, end, split);
        const auto children = skeleton_.split(tree, box, firstSlot_ + split.middle);
        if (tree.size() < kParallelSize) {
            build(children.first);
            build(children.second);
        } else {
            tbb::parallel_invoke([&] { build(children.first); }, [&] { build(children.second); });
        }
    }

  private:
    void sort(int axis) {
        std::vector<std::uint32_t>& order = order_[axis];
        order.resize(refs_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const float ca = refs_[a].centroid(axis), cb = refs_[b].centroid(axis);
            return ca < cb || (ca == cb && a < b);
        });
    }

    Bounds4 boxOf(std::size_t begin, std::size_t end) const {
        Bounds4 box;
        for (std::size_t i = begin; i < end; ++i) box.extend(refs_[order_[0][i]].bounds());
        return box;
    }

    void makeLeaf(const Subtree& tree, const Bounds4& box) {
        skeleton_.makeLeaf(tree, box);
        for (std::size_t i = tree.begin; i < tree.end; ++i)
            skeleton_.slot(i) = refs_[order_[0][i - firstSlot_]].primitive;
    }

    Split bestSplit(const Subtree& tree, Bounds4& box) {
        const std::size_t begin = tree.begin - firstSlot_, end = tree.end - firstSlot_;
        Split best;
        bool distinct = false;
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = sweep(axis, begin, end, box);
            if (split.isBetterThan(best)) best = split;
            distinct |=
                refs_[order_[axis][begin]].centroid(axis) != refs_[order_[axis][end - 1]].centroid(axis);
        }
        if (!distinct || TreeSkeleton::mustBeHalved(tree)) return {best.cost, begin + tree.size() / 2, 0, 0};
        return best;
    }

    /// Areas of all boxes from the right, then costs from the left.
    Split sweep(int axis, std::size_t begin, std::size_t end, Bounds4& box) {
        const std::vector<std::uint32_t>& order = order_[axis];
        std::vector<float>& rightArea = areas_[axis];
        Bounds4 right;
        for (std::size_t i = end; i-- > begin;) {
            right.extend(refs_[order[i]].bounds());
            rightArea[i] = right.halfArea(scale_);
        }
        box = right;
        Split best;
        Bounds4 left;
        for (std::size_t i = begin + 1; i < end; ++i) {
            left.extend(refs_[order[i - 1]].bounds());
            const float cost = left.halfArea(scale_) * static_cast<float>(i - begin) +
                               rightArea[i] * static_cast<float>(end - i);
            const std::size_t before = i - begin, after = end - i;
            const Split split{cost, i, before > after ? before - after : after - before, axis};
            if (split.isBetterThan(best)) best = split;
        }
        return best;
    }

    /// Moves what belongs to the left child to the front in all three orders, and keeps each order otherwise.
    void partition(std::size_t begin, std::size_t end, const Split& split) {
        for (std::size_t i = begin; i < end; ++i) onRight_[order_[split.axis][i]] = i >= split.middle;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == split.axis) continue;
            std::vector<std::uint32_t>& order = order_[axis];
            std::vector<std::uint32_t>& right = scratch_[axis];
            std::size_t lefts = begin, rights = begin;
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t ref = order[i];
                if (onRight_[ref]) {
                    right[rights++] = ref;
                } else {
                    order[lefts++] = ref;
                }
            }
            std::copy(right.begin() + static_cast<std::ptrdiff_t>(begin),
                      right.begin() + static_cast<std::ptrdiff_t>(rights),
                      order.begin() + static_cast<std::ptrdiff_t>(lefts));
        }
    }

    TreeSkeleton& skeleton_;
    const std::stop_token stop_;
    std::span<const PrimitiveRef> refs_;
    std::size_t firstSlot_;
    float scale_;
    std::vector<std::uint32_t> order_[3];
    std::vector<float> areas_[3];
    std::vector<std::uint32_t> scratch_[3];
    std::vector<std::uint8_t> onRight_;
};

}  // namespace

void buildSweep(TreeSkeleton& skeleton, std::span<const PrimitiveRef> refs, const Subtree& tree,
                float scale) {
    SweepBuilder(skeleton, refs, tree.begin, scale).build(tree);
}

}  // namespace rayscope
