#include "bvh/traversal/traversal_counts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "bvh/intersect/ray_data.h"
#include "bvh/traversal/traverse.h"
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_baseline.inl"
// clang-format on
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::bvh {
namespace {

struct WideCounter : NullTraversalObserver {
    TraversalCounts& counts;

    explicit WideCounter(TraversalCounts& to) : counts(to) {}
    void visit(kernel::ChildRef ref, float) const {
        if ((ref & kernel::kTagMask) == 0) {
            ++counts.nodes;
        } else {
            ++counts.leaves;
            counts.primitives += ref >= kernel::kSphereTag ? 1 : kernel::trianglesIn(ref);
        }
    }
    void test(std::uint32_t, bool, const kernel::HitData&, float) const { ++counts.exact; }
};

struct BinaryCounter : NullTraversalObserver {
    const BinaryTree& tree;
    TraversalCounts& counts;

    BinaryCounter(const BinaryTree& t, TraversalCounts& to) : tree(t), counts(to) {}
    void visit(std::uint32_t node, float) const {
        ++(tree.nodes[node].isLeaf() ? counts.leaves : counts.nodes);
    }
    void test(std::uint32_t, bool, const kernel::HitData&, float) const {
        ++counts.primitives;
        ++counts.exact;
    }
};

}  // namespace

TraversalCounts& TraversalCounts::operator+=(const TraversalCounts& other) {
    nodes += other.nodes;
    leaves += other.leaves;
    primitives += other.primitives;
    exact += other.exact;
    return *this;
}

bool countTraversal(const WideTree& tree, const Ray& ray, bool any, TraversalCounts& counts) {
    if (!RayQuery::isTraceable(ray)) return false;
    const WideCounter counter(counts);
    return kernel::traverseObserved(tree.view(), rayData(ray), any, counter);
}

bool countTraversal(const BinaryTree& tree, const AccelInput& input, const Ray& ray, bool any,
                    TraversalCounts& counts) {
    const BinaryCounter counter(tree, counts);
    Hit hit;
    return any ? traverse<QueryKind::Any>(tree, input, ray, hit, counter)
               : traverse<QueryKind::Closest>(tree, input, ray, hit, counter);
}

bool countTraversal(const Accel& accel, const Ray& ray, bool any, TraversalCounts& counts) {
    if (const WideTree* wide = accel.wideTree()) return countTraversal(*wide, ray, any, counts);
    const BinaryTree* binary = accel.binaryTree();
    return binary != nullptr && countTraversal(*binary, accel.input(), ray, any, counts);
}

TraversalCounts countTraversals(const WideTree& tree, std::span<const Ray> rays, bool any) {
    const auto count = [&](const auto& range, TraversalCounts counts) {
        for (const Ray& ray : rays.subspan(range.begin(), range.size()))
            countTraversal(tree, ray, any, counts);
        return counts;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, rays.size(), 4096), TraversalCounts{},
                                count, [](TraversalCounts a, const TraversalCounts& b) { return a += b; });
}

}  // namespace rayscope::bvh
