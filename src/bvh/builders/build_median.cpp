#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "bvh/builders/builders.h"
#include "bvh/layout/primitive_refs.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

struct MedianBuilder {
    TreeSkeleton& skeleton;
    std::span<PrimitiveRef> refs;

    void build(const Subtree& tree) const {
        const auto range = refs.subspan(tree.begin, tree.size());
        const Bounds4 box = boundsOf(range, skeleton.settings().stop).box;
        if (skeleton.mustBeLeaf(tree) ||
            tree.size() <= static_cast<std::size_t>(skeleton.settings().leafSize)) {
            skeleton.makeLeaf(tree, box);
            for (std::size_t i = tree.begin; i < tree.end; ++i) skeleton.slot(i) = refs[i].primitive;
            return;
        }
        const std::size_t half = splitAtMedian(range, tree.level % 3, skeleton.settings().stop);
        const auto [left, right] = skeleton.split(tree, box, tree.begin + half);
        if (tree.size() < kTaskSize) {
            build(left);
            build(right);
        } else {
            tbb::parallel_invoke([&] { build(left); }, [&] { build(right); });
        }
    }
};

}  // namespace

std::size_t splitAtMedian(std::span<PrimitiveRef> refs, int axis, const std::stop_token& stop) {
    std::size_t comparisons = 0;
    const auto less = [&](const PrimitiveRef& a, const PrimitiveRef& b) {
        if (++comparisons % 16384 == 0) throwIfStopped(stop);
        const float ca = a.centroid(axis), cb = b.centroid(axis);
        return ca < cb || (ca == cb && a.primitive < b.primitive);
    };
    const std::size_t half = refs.size() / 2;
    std::nth_element(refs.begin(), refs.begin() + static_cast<std::ptrdiff_t>(half), refs.end(), less);
    return half;
}

void buildMedian(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs) {
    MedianBuilder{skeleton, refs}.build(skeleton.whole());
}

}  // namespace rayscope::bvh
