#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "bvh/builders.h"
#include "bvh/statistics.h"
#include "bvh/stop_check.h"

namespace rayscope {
namespace {

constexpr std::size_t kParallelSize = 4096;
constexpr std::size_t kGrain = 16384;

/// Maps centroids to equally wide bins on each axis. An axis along which all centroids are (nearly) equal has
/// none.
struct BinMapping {
    BinMapping(const Bounds4& centroids, int binCount) : lowest(centroids.lower), last(binCount - 1) {
        for (int axis = 0; axis < 3; ++axis) {
            const float scale =
                static_cast<float>(binCount) / (centroids.upper[axis] - centroids.lower[axis]);
            isUsable[axis] = scale > 0.0f && std::isfinite(scale);
            perUnit[axis] = isUsable[axis] ? scale : 0.0f;
        }
    }

    /// On all axes.
    Int4 bins(Float4 centroid) const {
        const Int4 bin = __builtin_convertvector((centroid - lowest) * perUnit, Int4);
        const Int4 limit{last, last, last, last};
        return bin < limit ? bin : limit;
    }

    Float4 lowest, perUnit{};
    int last;
    bool isUsable[3];
};

/// What falls into the bins of the three axes. Boxes and counts can be added in any order with the same
/// result.
class Histogram {
  public:
    explicit Histogram(int binCount) : binCount_(static_cast<std::size_t>(binCount)), bins_(3 * binCount_) {}

    struct Bin {
        Bounds4 box;
        std::size_t count = 0;
    };
    const Bin& bin(int axis, std::size_t i) const {
        return bins_[static_cast<std::size_t>(axis) * binCount_ + i];
    }

    void add(std::span<const PrimitiveRef> refs, const BinMapping& mapping) {
        for (const PrimitiveRef& ref : refs) {
            const Bounds4 box = ref.bounds();
            const Int4 bins = mapping.bins(ref.centroid());
            for (int axis = 0; axis < 3; ++axis) {
                Bin& place =
                    bins_[static_cast<std::size_t>(axis) * binCount_ + static_cast<std::size_t>(bins[axis])];
                place.box.extend(box);
                ++place.count;
            }
        }
    }
    void add(const Histogram& other) {
        for (std::size_t i = 0; i < bins_.size(); ++i) {
            bins_[i].box.extend(other.bins_[i].box);
            bins_[i].count += other.bins_[i].count;
        }
    }

  private:
    std::size_t binCount_;
    std::vector<Bin> bins_;
};

Histogram histogramOf(std::span<const PrimitiveRef> refs, const BinMapping& mapping,
                      const BuildSettings& settings) {
    using Block = tbb::blocked_range<std::size_t>;
    const auto add = [&](const Block& block, Histogram sum) {
        throwIfStopped(settings.stop);
        sum.add(refs.subspan(block.begin(), block.size()), mapping);
        return sum;
    };
    const Block all(0, refs.size(), std::max(kGrain, static_cast<std::size_t>(4 * settings.bins)));
    if (!all.is_divisible()) return add(all, Histogram(settings.bins));
    return tbb::parallel_reduce(all, Histogram(settings.bins), add, [](Histogram a, const Histogram& b) {
        a.add(b);
        return a;
    });
}

struct Split {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;  ///< −1: no border of bins separates the centroids
    std::size_t firstRightBin = 0;
};

/// Moves the border from bin to bin, with the areas to its right computed before.
Split bestSplit(const Histogram& histogram, int axis, std::size_t binCount, std::size_t size, float scale) {
    std::vector<float> rightArea(binCount);
    Bounds4 right;
    for (std::size_t i = binCount; i-- > 1;) {
        right.extend(histogram.bin(axis, i).box);
        rightArea[i] = right.halfArea(scale);
    }
    Split best;
    Bounds4 left;
    std::size_t before = 0;
    for (std::size_t i = 1; i < binCount; ++i) {
        left.extend(histogram.bin(axis, i - 1).box);
        before += histogram.bin(axis, i - 1).count;
        if (before == 0 || before == size) continue;
        const float cost = left.halfArea(scale) * static_cast<float>(before) +
                           rightArea[i] * static_cast<float>(size - before);
        if (cost < best.cost) best = {cost, axis, i};
    }
    return best;
}

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

        const BinMapping mapping(bounds.centroids, settings.bins);
        const Split split = TreeSkeleton::mustBeHalved(tree) ? Split{} : bestSplitOf(range, mapping);
        if (split.axis >= 0 && isLeafCheaper(tree, bounds, split)) return makeLeaf(tree, bounds.box);
        const std::size_t lefts = split.axis >= 0 ? partition(range, mapping, split) : halve(range, bounds);
        const auto children = skeleton.split(tree, bounds.box, tree.begin + lefts);
        if (tree.size() < kParallelSize) {
            build(children.first);
            build(children.second);
        } else {
            tbb::parallel_invoke([&] { build(children.first); }, [&] { build(children.second); });
        }
    }

    void build(const Subtree& tree) const {
        build(tree, boundsOf(refs.subspan(tree.begin, tree.size()), skeleton.settings().stop));
    }

    void makeLeaf(const Subtree& tree, const Bounds4& box) const {
        skeleton.makeLeaf(tree, box);
        for (std::size_t i = tree.begin; i < tree.end; ++i) skeleton.slot(i) = refs[i].primitive;
    }

    Split bestSplitOf(std::span<const PrimitiveRef> range, const BinMapping& mapping) const {
        const Histogram histogram = histogramOf(range, mapping, skeleton.settings());
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!mapping.isUsable[axis]) continue;
            const auto binCount = static_cast<std::size_t>(skeleton.settings().bins);
            const Split split = bestSplit(histogram, axis, binCount, range.size(), scale);
            if (split.cost < best.cost) best = split;
        }
        return best;
    }

    bool isLeafCheaper(const Subtree& tree, const RangeBounds& bounds, const Split& split) const {
        return tree.size() <= static_cast<std::size_t>(skeleton.settings().leafSize) &&
               leafCost(bounds.box.halfArea(scale), tree.size()) <=
                   splitCost(bounds.box.halfArea(scale), split.cost);
    }

    std::size_t partition(std::span<PrimitiveRef> range, const BinMapping& mapping,
                          const Split& split) const {
        std::size_t asked = 0;
        const auto firstRightBin = static_cast<int>(split.firstRightBin);
        const auto middle = std::partition(range.begin(), range.end(), [&](const PrimitiveRef& ref) {
            if (++asked % kGrain == 0) throwIfStopped(skeleton.settings().stop);
            const Int4 bins = mapping.bins(ref.centroid());
            return (split.axis == 0 ? bins[0] : split.axis == 1 ? bins[1] : bins[2]) < firstRightBin;
        });
        return static_cast<std::size_t>(middle - range.begin());
    }

    /// Where no border separates the centroids, or the tree is about to become too deep.
    std::size_t halve(std::span<PrimitiveRef> range, const RangeBounds& bounds) const {
        const Float4 size = bounds.centroids.upper - bounds.centroids.lower;
        const int axis = size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
        return halveAtMedian(range, axis, skeleton.settings().stop);
    }
};

}  // namespace

void buildBinned(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs, float scale) {
    BinnedBuilder{skeleton, refs, scale}.build(skeleton.whole());
}

}  // namespace rayscope
