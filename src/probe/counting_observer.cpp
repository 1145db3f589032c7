#include "probe/counting_observer.h"

#include "trace/shadow_ray.h"

namespace rayscope::probe {

void CountingObserver::count(const Ray& ray, bool any) {
    for (const trace::MotionGroup& motionGroup : world_.motionGroups) {
        const trace::Geometry& geometry = *motionGroup.geometry;
        if (!world_.settings.bvh) {
            counts_.primitives += geometry.input.triangles.size() + geometry.input.spheres.size();
            continue;
        }
        if (!motionGroup.accel) continue;
        const Ray atRest = geometry.inRestFrame(ray, time_);
        const bool found = bvh::countTraversal(*motionGroup.accel, atRest, any, counts_);
        if (any && found) return;
    }
}

void CountingObserver::lightSampled(const trace::LightConnection& light, const glm::dvec3&) {
    const bool isTraced = light.visibility != Visibility::FacingAway &&
                          world_.lights[static_cast<std::size_t>(light.light)].castsShadows;
    if (isTraced) count(trace::shadowRay(light.from, light.at.position), !world_.attenuatesShadows);
}

void CountingObserver::ended(const trace::Segment& segment, RayEnd why) {
    if (why == RayEnd::Missed) count(segment.ray, false);
}

}  // namespace rayscope::probe
