#include "probe/wide_traversal.h"

#include <limits>
#include <unordered_map>

#include "bvh/intersect/ray_query.h"
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_portable.inl"
// clang-format on
#include "bvh/kernel/traverse_wide.inl"

namespace rayscope::probe {

namespace {

using bvh::kernel::ChildRef, bvh::kernel::HitData, bvh::kernel::QueryState, bvh::kernel::TriangleBlock,
    bvh::kernel::WideNode;

constexpr float kNoDistance = std::numeric_limits<float>::quiet_NaN();

bvh::PrimitiveBox boxOfChild(const WideNode& node, int lane) {
    const auto& p = node.planes;
    return {{p[0][lane], p[2][lane], p[4][lane], 0.0f, p[1][lane], p[3][lane], p[5][lane], 0.0f}};
}

glm::vec3 lowerOf(const bvh::PrimitiveBox& box) { return {box.planes[0], box.planes[1], box.planes[2]}; }
glm::vec3 upperOf(const bvh::PrimitiveBox& box) { return {box.planes[4], box.planes[5], box.planes[6]}; }

/// Nodes, and after them blocks and spheres, count from 0.
std::uint32_t numberOf(const bvh::WideTree& tree, ChildRef ref) {
    if (ref >= bvh::kernel::kSphereTag)
        return static_cast<std::uint32_t>(tree.blocks.size()) + (ref & bvh::kernel::kSphereIndexMask);
    return (ref & bvh::kernel::kTagMask) != 0 ? ref & bvh::kernel::kBlockIndexMask : ref;
}

int trianglesOf(ChildRef block) { return static_cast<int>(bvh::kernel::trianglesIn(block)); }

/// The root's box is stored nowhere: nothing needs it but those who look.
void findRootBox(const bvh::WideTree& tree, TraversalBox& box) {
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
                const glm::vec3 place(corner[0][lane], corner[1][lane], corner[2][lane]);
                include(place, place);
            }
    } else {
        for (int lane = 0; lane < bvh::kernel::kWidth; ++lane) {
            const bvh::PrimitiveBox child = boxOfChild(tree.nodes[tree.root], lane);
            if (child.planes[0] <= child.planes[4]) include(lowerOf(child), upperOf(child));
        }
    }
}

/// Writes down what a walk through the wide tree tells.
class WideRecorder {
  public:
    WideRecorder(TraversalLog& log, const bvh::WideTree& tree) : log_(log), tree_(tree), query_(log.ray) {
        findRootBox(tree, log_.boxes[boxOf(tree.root)]);
        const glm::vec3 lower = log_.boxes[0].lower, upper = log_.boxes[0].upper;
        entries_[0] = entryOf({{lower.x, lower.y, lower.z, 0.0f, upper.x, upper.y, upper.z, 0.0f}});
    }

    void visit(ChildRef ref, const QueryState& search) {
        const std::uint32_t box = boxOf(ref);
        add(TraversalEvent::Visited, box, entries_[box], search);
        current_ = static_cast<int>(box);
    }
    void children(const WideNode& node, unsigned mask, const bvh::kernel::Lanes& entry,
                  const QueryState& search) {
        bound_ = search.best.t;
        for (int lane = 0; lane < bvh::kernel::kWidth; ++lane) {
            const bvh::PrimitiveBox planes = boxOfChild(node, lane);
            if (!(planes.planes[0] <= planes.planes[4])) continue;
            const std::uint32_t box = boxOf(node.child[lane]);
            log_.boxes[box].lower = lowerOf(planes);
            log_.boxes[box].upper = upperOf(planes);
            const bool isMet = (mask >> lane & 1u) != 0;
            entries_[box] = isMet ? static_cast<float>(entry.value[lane] / search.scale) : entryOf(planes);
            if (isMet) continue;
            // It is rejected: because of a closer hit, or because it is off the ray?
            add(std::isnan(entries_[box]) ? TraversalEvent::Missed : TraversalEvent::Culled, box,
                entries_[box], search);
        }
    }
    void push(ChildRef ref) {
        const std::uint32_t box = boxOf(ref);
        log_.steps.push_back({TraversalEvent::Pushed, box, entries_[box], bound_});
    }
    void cull(ChildRef ref, const QueryState& search) {
        const std::uint32_t box = boxOf(ref);
        add(TraversalEvent::Culled, box, entries_[box], search);
    }
    void filtered(const TriangleBlock& block, ChildRef leaf, unsigned mask, const QueryState& search) {
        for (int lane = 0; lane < trianglesOf(leaf); ++lane)
            if ((mask >> lane & 1u) == 0)
                add(TraversalEvent::Filtered, block.primitive[lane], kNoDistance, search);
    }
    void test(std::uint32_t primitive, bool isHit, const HitData& hit, const QueryState& search) {
        const Hit found{hit.t, primitive, hit.u, hit.v};
        Hit best{search.best.t, search.best.primitive, 0.0f, 0.0f};
        const bool isCloser = isHit && bvh::keepCloser(found, best);
        add(isCloser ? TraversalEvent::Hit : TraversalEvent::NoHit, primitive, isHit ? hit.t : kNoDistance,
            search);
        if (isCloser) log_.hit = found;
    }

  private:
    /// Where the ray enters a box, whatever it has hit; NaN if it does not.
    float entryOf(const bvh::PrimitiveBox& box) const {
        float entry;
        if (!bvh::intersectBox(box.planes, query_.box, query_.box.tMax, entry)) return kNoDistance;
        return static_cast<float>(entry / query_.box.scale);
    }
    /// A new box is the root or a child of the node that was entered last.
    std::uint32_t boxOf(ChildRef ref) {
        const auto [known, isNew] = known_.try_emplace(ref, static_cast<std::uint32_t>(log_.boxes.size()));
        if (isNew) {
            log_.boxes.push_back(
                {numberOf(tree_, ref), current_, (ref & bvh::kernel::kTagMask) != 0, {}, {}});
            entries_.push_back(kNoDistance);
        }
        return known->second;
    }
    void add(TraversalEvent event, std::uint32_t number, float t, const QueryState& search) {
        log_.steps.push_back({event, number, t, search.best.t});
    }

    TraversalLog& log_;
    const bvh::WideTree& tree_;
    bvh::RayQuery query_;
    std::unordered_map<ChildRef, std::uint32_t> known_;  ///< ref → box
    std::vector<float> entries_;                         ///< of boxes, where they were tested last
    int current_ = -1;                                   ///< box
    float bound_ = 0.0f;
};

/// The recorder as the walk hands it on: by value.
struct WideObserver {
    WideRecorder* to;
    void visit(ChildRef ref, const QueryState& search) const { to->visit(ref, search); }
    void children(const WideNode& node, unsigned mask, const bvh::kernel::Lanes& entry,
                  const QueryState& search) const {
        to->children(node, mask, entry, search);
    }
    void push(ChildRef ref) const { to->push(ref); }
    void cull(ChildRef ref, const QueryState& search) const { to->cull(ref, search); }
    void filtered(const TriangleBlock& block, ChildRef leaf, unsigned mask, const QueryState& search) const {
        to->filtered(block, leaf, mask, search);
    }
    void certainHit(std::uint32_t primitive, const HitData& hit, const QueryState& search) const {
        to->test(primitive, true, hit, search);
    }
    void test(std::uint32_t primitive, bool isHit, const HitData& hit, const QueryState& search) const {
        to->test(primitive, isHit, hit, search);
    }
};

}  // namespace

void recordWideTraversal(const bvh::WideTree& tree, TraversalLog& log) {
    WideRecorder recorder(log, tree);
    bvh::kernel::traverseObserved(tree.view(), bvh::rayData(log.ray), log.anyHit, WideObserver{&recorder});
}

}  // namespace rayscope::probe
