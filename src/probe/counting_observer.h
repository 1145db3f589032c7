#pragma once
#include "bvh/traversal/traversal_counts.h"
#include "trace/path_observer.h"
#include "trace/world.h"

namespace rayscope::probe {

/// Counts the traversals of a sample: repeats the query of every ray with a counter, in the tree that
/// production rays traverse (see bvh::countTraversal()). Without a BVH every primitive counts as tested. With
/// attenuated shadows a shadow ray counts up to its first surface.
class CountingObserver {
  public:
    /// `time` is that of the shutter.
    CountingObserver(const trace::World& world, float time) : world_(world), time_(time) {}

    void segment(const trace::Segment& segment) { ray_ = segment.ray; }
    void hit(const trace::Interaction&) { count(ray_, false); }
    void lightSampled(const trace::LightConnection& light, const glm::dvec3&);
    static void added(const glm::dvec3&) {}
    void ended(const trace::Segment& segment, RayEnd why);

    const bvh::TraversalCounts& counts() const { return counts_; }

  private:
    void count(const Ray& ray, bool any);

    const trace::World& world_;
    float time_;
    Ray ray_;
    bvh::TraversalCounts counts_;
};
static_assert(trace::PathObserver<CountingObserver>);

}  // namespace rayscope::probe
