#include "bvh/traversal/traversal_counts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "bvh/intersect/ray_data.h"
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_portable.inl"
// clang-format on
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::bvh {
namespace {

using kernel::ChildRef, kernel::HitData, kernel::QueryState, kernel::TriangleBlock, kernel::WideNode;

struct Counter {
    TraversalCounts* counts;

    void visit(ChildRef ref, const QueryState&) const {
        if ((ref & kernel::kTagMask) == 0) ++counts->nodes;
        if (ref >= kernel::kSphereTag) ++counts->leaves, ++counts->primitives;
    }
    static void children(const WideNode&, unsigned, const kernel::Lanes&, const QueryState&) {}
    static void push(ChildRef) {}
    static void cull(ChildRef, const QueryState&) {}
    void filtered(const TriangleBlock&, ChildRef leaf, unsigned, const QueryState&) const {
        ++counts->leaves;
        counts->primitives += kernel::trianglesIn(leaf);
    }
    static void certainHit(std::uint32_t, const HitData&, const QueryState&) {}
    void test(std::uint32_t, bool, const HitData&, const QueryState&) const { ++counts->exact; }
};

TraversalCounts sum(const TraversalCounts& a, const TraversalCounts& b) {
    return {a.nodes + b.nodes, a.leaves + b.leaves, a.primitives + b.primitives, a.exact + b.exact};
}

}  // namespace

TraversalCounts countTraversals(const WideTree& tree, std::span<const Ray> rays, bool any) {
    const kernel::WideTreeView view = tree.view();
    const auto count = [&](const auto& range, TraversalCounts counts) {
        const Counter counter{&counts};
        for (const Ray& ray : rays.subspan(range.begin(), range.size())) {
            if (kernel::isTraceable(rayData(ray))) kernel::traverseObserved(view, rayData(ray), any, counter);
        }
        return counts;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, rays.size(), 4096), TraversalCounts{},
                                count, sum);
}

}  // namespace rayscope::bvh
