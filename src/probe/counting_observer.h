#pragma once
#include "bvh/traversal/traverse.h"
#include "trace/path_observer.h"
#include "trace/shadow_ray.h"

namespace rayscope::probe {

/// Counts what a walk through the binary tree does.
struct TraversalCounter {
    std::uint64_t nodes = 0, tests = 0;
    void visit(std::uint32_t, float) { ++nodes; }
    static void cull(std::uint32_t, float) {}
    static void miss(std::uint32_t) {}
    void test(std::uint32_t, bool) { ++tests; }
    static void push(std::uint32_t) {}
};
static_assert(bvh::TraversalObserver<TraversalCounter>);

/// The walk of traverseAny(), watched: it enters a box that is hit, says which children wait, and ends at
/// the first hit.
template <bvh::TraversalObserver O>
bool anyHitObserved(const bvh::BinaryTree& tree, const AccelInput& input, const Ray& ray, O& observer,
                    Hit& hit) {
    if (tree.nodes.empty() || !bvh::RayQuery::isTraceable(ray)) return false;
    const bvh::RayQuery query(ray);
    const bvh::IndexedPrimitives primitives{input, tree.primitives};
    std::uint32_t stack[bvh::kMaxTreeLevel + 1] = {0};
    int waiting = 1;
    float entry;
    while (waiting > 0) {
        const std::uint32_t number = stack[--waiting];
        const bvh::BinaryNode& node = tree.nodes[number];
        if (!bvh::intersectBox(bvh::planes(node), query.box, query.box.tMax, entry)) {
            observer.miss(number);
            continue;
        }
        observer.visit(number, ray.tMax);
        if (!node.isLeaf()) {
            for (const std::uint32_t child : {node.first + 1, node.first}) {
                stack[waiting++] = child;
                observer.push(child);
            }
            continue;
        }
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
            const bool found = primitives.hits(query, slot, ray.tMax, hit);
            observer.test(primitives.number(slot), found);
            hit.primitive = primitives.number(slot);
            if (found) return true;
        }
    }
    return false;
}

/// Walks the binary tree a second time for every ray that the tracer sends out, and counts. The tracer itself
/// is not slowed down by counters that nobody asked for, because it has none. With attenuated shadows a
/// shadow ray counts as far as its first surface.
class CountingObserver {
  public:
    CountingObserver(const trace::World& world, float time) : world_(world), time_(time) {}

    void segment(const trace::Segment& segment) { ray_ = segment.ray; }
    void hit(const trace::Interaction&) { countClosest(ray_); }
    void lightSampled(const trace::LightConnection& light, const glm::dvec3&);
    static void added(const glm::dvec3&) {}
    void ended(const trace::Segment& segment, RayEnd why) {
        if (why == RayEnd::Missed) countClosest(segment.ray);
    }

    const TraversalCounter& counted() const { return counter_; }

  private:
    template <class Count>
    void forEachGroup(const Ray& ray, Count&& count);
    void countClosest(const Ray& ray);

    const trace::World& world_;
    float time_;
    Ray ray_;
    TraversalCounter counter_;
};

}  // namespace rayscope::probe
