#include "probe/wide_traversal.h"

#include <limits>
#include <unordered_map>

#include "bvh/intersect/ray_query.h"
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_baseline.inl"
// clang-format on
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::probe {

namespace {

using bvh::kernel::ChildRef, bvh::kernel::HitData, bvh::kernel::TriangleBlock, bvh::kernel::WideNode;

constexpr float kNoDistance = std::numeric_limits<float>::quiet_NaN();

bvh::PrimitiveBox boxOfChild(const WideNode& node, int lane) {
    const auto& p = node.planes;
    return {{p[0][lane], p[2][lane], p[4][lane], 0.0f, p[1][lane], p[3][lane], p[5][lane], 0.0f}};
}

glm::vec3 lowerOf(const bvh::PrimitiveBox& box) { return {box.planes[0], box.planes[1], box.planes[2]}; }
glm::vec3 upperOf(const bvh::PrimitiveBox& box) { return {box.planes[4], box.planes[5], box.planes[6]}; }

/// The number of an inner node, or of a leaf: blocks first, then spheres.
std::uint32_t numberOf(const bvh::WideTree& tree, ChildRef ref) {
    if (ref >= bvh::kernel::kSphereTag)
        return static_cast<std::uint32_t>(tree.blocks.size()) + (ref & bvh::kernel::kSphereIndexMask);
    return (ref & bvh::kernel::kTagMask) != 0 ? ref & bvh::kernel::kBlockIndexMask : ref;
}

int trianglesOf(ChildRef block) { return static_cast<int>(bvh::kernel::trianglesIn(block)); }

/// The box of the root, which the tree does not store because traversals do not need it.
void computeRootBox(const bvh::WideTree& tree, TraversalBox& box) {
    box.lower = glm::vec3(bvh::kernel::kInfinity);
    box.upper = -box.lower;
    const auto include = [&](glm::vec3 lower, glm::vec3 upper) {
        box.lower = glm::min(box.lower, lower);
        box.upper = glm::max(box.upper, upper);
    };
    if (tree.root >= bvh::kernel::kSphereTag) {
        const float* s = tree.spheres[tree.root & bvh::kernel::kSphereIndexMask].sphere;
        const bvh::PrimitiveBox own = bvh::boxOf(Sphere{{s[0], s[1], s[2]}, s[3]});
        include(lowerOf(own), upperOf(own));
    } else if ((tree.root & bvh::kernel::kTagMask) != 0) {
        const TriangleBlock& block = tree.blocks[tree.root & bvh::kernel::kBlockIndexMask];
        for (const auto& corner : block.corner)
            for (int lane = 0; lane < trianglesOf(tree.root); ++lane) {
                const glm::vec3 position(corner[0][lane], corner[1][lane], corner[2][lane]);
                include(position, position);
            }
    } else {
        for (int lane = 0; lane < bvh::kernel::kWidth; ++lane) {
            const bvh::PrimitiveBox child = boxOfChild(tree.nodes[tree.root], lane);
            if (child.planes[0] <= child.planes[4]) include(lowerOf(child), upperOf(child));
        }
    }
}

/// Records a traversal of a wide tree.
class WideTraversalRecorder : public bvh::NullTraversalObserver {
  public:
    WideTraversalRecorder(TraversalLog& log, const bvh::WideTree& tree) : log_(log), tree_(tree) {
        TraversalBox& root = log_.boxes[boxOf(tree.root)];
        computeRootBox(tree, root);
        const float planes[] = {root.lower.x, root.lower.y, root.lower.z, 0.0f,
                                root.upper.x, root.upper.y, root.upper.z, 0.0f};
        const bvh::RayQuery query(log.ray);
        float entry;
        if (bvh::intersectBox(planes, query.box, query.box.tMax, entry))
            entries_[0] = static_cast<float>(entry / query.box.scale);
    }

    void intersect(ChildRef ref, float entry) { entries_[boxOf(ref)] = entry; }
    void miss(ChildRef ref, float bound) { addBox(TraversalEvent::Missed, ref, bound); }
    void cull(ChildRef ref, float bound) { addBox(TraversalEvent::Culled, ref, bound); }
    void push(ChildRef ref, float bound) { addBox(TraversalEvent::Pushed, ref, bound); }
    void visit(ChildRef ref, float bound) {
        addBox(TraversalEvent::Visited, ref, bound);
        visited_ = static_cast<int>(boxOf(ref));
        if ((ref & bvh::kernel::kTagMask) == 0) addChildren(tree_.nodes[ref]);
    }
    void filter(std::uint32_t primitive, float bound) {
        log_.steps.push_back({TraversalEvent::Filtered, primitive, kNoDistance, bound});
    }
    void certainHit(std::uint32_t primitive, const HitData& hit, float bound) {
        test(primitive, true, hit, bound);
    }
    void test(std::uint32_t primitive, bool isHit, const HitData& hit, float bound) {
        const Hit found{hit.t, primitive, hit.u, hit.v};
        Hit best{bound, log_.hit.primitive, 0.0f, 0.0f};
        const bool isCloser = isHit && bvh::keepCloser(found, best);
        log_.steps.push_back({isCloser ? TraversalEvent::Hit : TraversalEvent::NoHit, primitive,
                              isHit ? hit.t : kNoDistance, bound});
        if (isCloser) log_.hit = found;
    }

  private:
    /// A new box is the root or a child of the node that was visited last.
    std::uint32_t boxOf(ChildRef ref) {
        const auto [known, isNew] = known_.try_emplace(ref, static_cast<std::uint32_t>(log_.boxes.size()));
        if (isNew) {
            log_.boxes.push_back(
                {numberOf(tree_, ref), visited_, (ref & bvh::kernel::kTagMask) != 0, {}, {}});
            entries_.push_back(kNoDistance);
        }
        return known->second;
    }
    void addChildren(const WideNode& node) {
        for (int lane = 0; lane < bvh::kernel::kWidth; ++lane) {
            const bvh::PrimitiveBox planes = boxOfChild(node, lane);
            const bool isPresent = planes.planes[0] <= planes.planes[4];
            if (!isPresent) continue;
            TraversalBox& box = log_.boxes[boxOf(node.child[lane])];
            box.lower = lowerOf(planes);
            box.upper = upperOf(planes);
        }
    }
    void addBox(TraversalEvent event, ChildRef ref, float bound) {
        const std::uint32_t box = boxOf(ref);
        log_.steps.push_back({event, box, entries_[box], bound});
    }

    TraversalLog& log_;
    const bvh::WideTree& tree_;
    std::unordered_map<ChildRef, std::uint32_t> known_;  ///< ref → box
    std::vector<float> entries_;                         ///< of boxes; NaN where missed
    int visited_ = -1;                                   ///< box of the node visited last
};
static_assert(bvh::TraversalObserver<WideTraversalRecorder>);

}  // namespace

void recordWideTraversal(const bvh::WideTree& tree, TraversalLog& log) {
    WideTraversalRecorder recorder(log, tree);
    bvh::kernel::traverseObserved(tree.view(), bvh::rayData(log.ray), log.anyHit, recorder);
}

}  // namespace rayscope::probe
