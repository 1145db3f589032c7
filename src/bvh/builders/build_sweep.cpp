#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "bvh/builders/builders.h"
#include "bvh/builders/sort_centroids.h"
#include "bvh/layout/primitive_refs.h"
#include "bvh/layout/statistics.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

constexpr std::size_t kParallelAxes = 65536;  ///< ranges from here on sweep the axes in parallel

struct SweepSplit {
    float cost = std::numeric_limits<float>::infinity();
    std::size_t middle = 0;  ///< relative to the first primitive of the builder
    std::size_t offCentre = 0;
    int axis = -1;

    /// Prefers the cheaper, of equal cost the more balanced split, so that equal boxes give a shallow tree.
    bool isBetterThan(const SweepSplit& other) const {
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
        forEachAxis(refs.size(), [this](int axis) {
            order_[axis] = orderByCentroid(refs_, axis, stop_);
            areas_[axis].resize(refs_.size());
            scratch_[axis].resize(refs_.size());
        });
    }

    void build(const Subtree& tree) {
        throwIfStopped(stop_);
        const std::size_t begin = tree.begin - firstSlot_, end = tree.end - firstSlot_;
        if (skeleton_.mustBeLeaf(tree)) return makeLeaf(tree, boxOf(begin, end));
        Bounds4 box;
        const SweepSplit split = bestSplit(tree, box);
        const float area = box.halfArea(scale_);
        if (tree.size() <= static_cast<std::size_t>(skeleton_.settings().leafSize) &&
            leafCost(area, tree.size()) <= splitCost(area, split.cost))
            return makeLeaf(tree, box);

        partition(begin, end, split);
        const auto children = skeleton_.split(tree, box, firstSlot_ + split.middle);
        if (tree.size() < kTaskSize) {
            build(children.first);
            build(children.second);
        } else {
            tbb::parallel_invoke([&] { build(children.first); }, [&] { build(children.second); });
        }
    }

  private:
    /// In parallel for long ranges.
    template <class Work>
    static void forEachAxis(std::size_t size, const Work& work) {
        if (size < kParallelAxes) {
            for (int axis = 0; axis < 3; ++axis) work(axis);
        } else {
            tbb::parallel_invoke([&] { work(0); }, [&] { work(1); }, [&] { work(2); });
        }
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

    SweepSplit bestSplit(const Subtree& tree, Bounds4& box) {
        const std::size_t begin = tree.begin - firstSlot_, end = tree.end - firstSlot_;
        SweepSplit splits[3];
        Bounds4 boxes[3];
        forEachAxis(tree.size(), [&](int axis) { splits[axis] = sweep(axis, begin, end, boxes[axis]); });
        box = boxes[0];
        SweepSplit best;
        for (const SweepSplit& split : splits)
            if (split.isBetterThan(best)) best = split;
        if (TreeSkeleton::mustSplitAtMedian(tree) || !haveDistinctCentroids(begin, end))
            return {best.cost, begin + tree.size() / 2, 0, 0};
        return best;
    }

    bool haveDistinctCentroids(std::size_t begin, std::size_t end) const {
        for (int axis = 0; axis < 3; ++axis)
            if (refs_[order_[axis][begin]].centroid(axis) != refs_[order_[axis][end - 1]].centroid(axis))
                return true;
        return false;
    }

    /// Areas from the right, then costs from the left.
    SweepSplit sweep(int axis, std::size_t begin, std::size_t end, Bounds4& box) {
        const base::BigVector<std::uint32_t>& order = order_[axis];
        base::BigVector<float>& rightArea = areas_[axis];
        Bounds4 right;
        for (std::size_t i = end; i-- > begin;) {
            if (i % kStopInterval == 0) throwIfStopped(stop_);
            right.extend(refs_[order[i]].bounds());
            rightArea[i] = right.halfArea(scale_);
        }
        box = right;
        SweepSplit best;
        Bounds4 left;
        for (std::size_t i = begin + 1; i < end; ++i) {
            if (i % kStopInterval == 0) throwIfStopped(stop_);
            left.extend(refs_[order[i - 1]].bounds());
            const float cost = left.halfArea(scale_) * static_cast<float>(i - begin) +
                               rightArea[i] * static_cast<float>(end - i);
            const std::size_t before = i - begin, after = end - i;
            const SweepSplit split{cost, i, before > after ? before - after : after - before, axis};
            if (split.isBetterThan(best)) best = split;
        }
        return best;
    }

    /// Stable partition of all three orders by child.
    void partition(std::size_t begin, std::size_t end, const SweepSplit& split) {
        for (std::size_t i = begin; i < end; ++i) onRight_[order_[split.axis][i]] = i >= split.middle;
        forEachAxis(end - begin, [&](int axis) {
            if (axis != split.axis) partition(axis, begin, end);
        });
    }

    void partition(int axis, std::size_t begin, std::size_t end) {
        base::BigVector<std::uint32_t>& order = order_[axis];
        base::BigVector<std::uint32_t>& right = scratch_[axis];
        std::size_t leftEnd = begin, rightEnd = begin;
        for (std::size_t i = begin; i < end; ++i) {
            if (i % kStopInterval == 0) throwIfStopped(stop_);
            const std::uint32_t ref = order[i];
            if (onRight_[ref]) {
                right[rightEnd++] = ref;
            } else {
                order[leftEnd++] = ref;
            }
        }
        std::copy(right.begin() + static_cast<std::ptrdiff_t>(begin),
                  right.begin() + static_cast<std::ptrdiff_t>(rightEnd),
                  order.begin() + static_cast<std::ptrdiff_t>(leftEnd));
    }

    TreeSkeleton& skeleton_;
    const std::stop_token stop_;
    std::span<const PrimitiveRef> refs_;
    std::size_t firstSlot_;
    float scale_;
    base::BigVector<std::uint32_t> order_[3];
    base::BigVector<float> areas_[3];
    base::BigVector<std::uint32_t> scratch_[3];
    std::vector<std::uint8_t> onRight_;
};

}  // namespace

void buildSweep(TreeSkeleton& skeleton, std::span<const PrimitiveRef> refs, const Subtree& tree,
                float scale) {
    SweepBuilder(skeleton, refs, tree.begin, scale).build(tree);
}

}  // namespace rayscope::bvh
