#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "bvh/builders.h"
#include "bvh/stop_check.h"

namespace rayscope {
namespace {

constexpr std::size_t kParallelSize = 4096;

struct Bin {
    Bounds4 box;
    std::size_t count = 0;
};

/// Maps centroids to bins.
struct BinMapping {
    float lowest, perUnit;
    int bins;

    std::size_t operator()(float centroid) const {
        return static_cast<std::size_t>(std::min(static_cast<int>((centroid - lowest) * perUnit), bins - 1));
    }
};

struct BinnedSplit {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    std::size_t firstRightBin = 0;
    BinMapping mapping{};
};

struct BinnedBuilder {
    TreeSkeleton& skeleton;
    std::span<PrimitiveRef> refs;
    float scale;

    void build(const Subtree& tree, const RangeBounds& bounds) const {
        const auto range = refs.subspan(tree.begin, tree.size());
        const BuildSettings& settings = skeleton.settings();
        throwIfStopped(settings.stop);
        if (skeleton.mustBeLeaf(tree)) return makeLeaf(tree, bounds.box);
        if (tree.size() <= static_cast<std::size_t>(settings.bins))
            return buildSweep(skeleton, range, tree, scale);

        const BinnedSplit split = TreeSkeleton::mustBeHalved(tree) ? BinnedSplit{} : bestSplit(range, bounds);
        if (split.axis >= 0 && isLeafCheaper(tree, bounds, split)) return makeLeaf(tree, bounds.box);
        const std::size_t middle =
            tree.begin + (split.axis >= 0 ? partition(range, split) : halve(range, bounds));
        const auto [left, right] = skeleton.split(tree, bounds.box, middle);
        const auto buildChild = [this](const Subtree& child) {
            build(child, boundsOf(refs.subspan(child.begin, child.size()), skeleton.settings().stop));
        };
        if (tree.size() < kParallelSize) {
            buildChild(left);
            buildChild(right);
        } else {
            tbb::parallel_invoke([&, child = left] { buildChild(child); },
                                 [&, child = right] { buildChild(child); });
        }
    }

    void makeLeaf(const Subtree& tree, const Bounds4& box) const {
        skeleton.makeLeaf(tree, box);
        for (std::size_t i = tree.begin; i < tree.end; ++i) skeleton.slot(i) = refs[i].primitive;
    }

    bool isLeafCheaper(const Subtree& tree, const RangeBounds& bounds, const BinnedSplit& split) const {
        const float area = bounds.box.halfArea(scale), count = static_cast<float>(tree.size());
        return tree.size() <= static_cast<std::size_t>(skeleton.settings().leafSize) &&
               count * kIntersectionCost * area <= kTraversalCost * area + kIntersectionCost * split.cost;
    }

    BinnedSplit bestSplit(std::span<const PrimitiveRef> range, const RangeBounds& bounds) const {
        const int bins = skeleton.settings().bins;
        BinnedSplit best;
        std::vector<Bin> histogram;
        std::vector<float> rightArea(static_cast<std::size_t>(bins));
        for (int axis = 0; axis < 3; ++axis) {
            const float lowest = bounds.centroids.lower[axis];
            const float perUnit = static_cast<float>(bins) / (bounds.centroids.upper[axis] - lowest);
            if (!(perUnit > 0.0f && std::isfinite(perUnit))) continue;
            const BinMapping mapping{lowest, perUnit, bins};
            histogram.assign(static_cast<std::size_t>(bins), Bin{});
            for (const PrimitiveRef& ref : range) {
                Bin& bin = histogram[mapping(ref.centroid(axis))];
                bin.box.extend(ref.bounds());
                ++bin.count;
            }
            Bounds4 box;
            for (std::size_t i = histogram.size(); i-- > 1;) {
                box.extend(histogram[i].box);
                rightArea[i] = box.halfArea(scale);
            }
            box = {};
            std::size_t before = 0;
            for (std::size_t i = 1; i < histogram.size(); ++i) {
                box.extend(histogram[i - 1].box);
                before += histogram[i - 1].count;
                if (before == 0) continue;
                if (before == range.size()) break;
                const float cost = box.halfArea(scale) * static_cast<float>(before) +
                                   rightArea[i] * static_cast<float>(range.size() - before);
                if (cost < best.cost) best = {cost, axis, i, mapping};
            }
        }
        return best;
    }

    static std::size_t partition(std::span<PrimitiveRef> range, const BinnedSplit& split) {
        const auto middle = std::partition(range.begin(), range.end(), [&](const PrimitiveRef& ref) {
            return split.mapping(ref.centroid(split.axis)) < split.firstRightBin;
        });
        return static_cast<std::size_t>(middle - range.begin());
    }

    /// No plane separates the centroids (or the tree is about to become too deep).
    static std::size_t halve(std::span<PrimitiveRef> range, const RangeBounds& bounds) {
        const Float4 size = bounds.centroids.upper - bounds.centroids.lower;
        const int axis = size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
        const std::size_t half = range.size() / 2;
        std::nth_element(range.begin(), range.begin() + static_cast<std::ptrdiff_t>(half), range.end(),
                         [axis](const PrimitiveRef& a, const PrimitiveRef& b) {
                             const float ca = a.centroid(axis), cb = b.centroid(axis);
                             return ca < cb || (ca == cb && a.primitive < b.primitive);
                         });
        return half;
    }
};

}  // namespace

void buildBinned(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs, float scale) {
    BinnedBuilder{skeleton, refs, scale}.build(skeleton.whole(), boundsOf(refs, skeleton.settings().stop));
}

}  // namespace rayscope
