#include "bvh/traversal/wide_counts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "bvh/intersect/ray_words.h"
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_portable.inl"
// clang-format on
#include "bvh/kernel/walk.inl"

namespace rayscope::bvh {
namespace {

using kernel::ChildRef, kernel::HitWords, kernel::Search, kernel::TriangleBlock, kernel::WideNode;

struct Counter {
    WideCounts* counts;

    void entered(ChildRef ref, const Search&) const {
        if ((ref & kernel::kTagMask) == 0) ++counts->nodes;
        if (ref >= kernel::kSphereTag) ++counts->leaves, ++counts->primitives;
    }
    static void children(const WideNode&, unsigned, const kernel::Lanes&, const Search&) {}
    static void waits(ChildRef) {}
    static void skipped(ChildRef, const Search&) {}
    void filtered(const TriangleBlock&, ChildRef leaf, unsigned, const Search&) const {
        ++counts->leaves;
        counts->primitives += kernel::trianglesIn(leaf);
    }
    static void surelyHit(std::uint32_t, const HitWords&, const Search&) {}
    void tested(std::uint32_t, bool, const HitWords&, const Search&) const { ++counts->exact; }
};

WideCounts sum(const WideCounts& a, const WideCounts& b) {
    return {a.nodes + b.nodes, a.leaves + b.leaves, a.primitives + b.primitives, a.exact + b.exact};
}

}  // namespace

WideCounts countSearches(const WideTree& tree, std::span<const Ray> rays, bool any) {
    const kernel::WideTreeView view = tree.view();
    const auto count = [&](const auto& range, WideCounts counts) {
        const Counter counter{&counts};
        for (const Ray& ray : rays.subspan(range.begin(), range.size())) {
            if (kernel::isTraceable(words(ray))) kernel::searchWatched(view, words(ray), any, counter);
        }
        return counts;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, rays.size(), 4096), WideCounts{}, count,
                                sum);
}

}  // namespace rayscope::bvh
