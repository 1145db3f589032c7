#include "bvh/traversal/traverse.h"

namespace rayscope::bvh {

bool closestHitBruteForce(const AccelInput& input, const Ray& ray, Hit& hit) {
    hit = Hit{};
    if (!RayQuery::isTraceable(ray)) return false;
    const RayQuery query(ray);
    const auto count = static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
    Hit best;
    best.t = ray.tMax;
    for (std::uint32_t primitive = 0; primitive < count; ++primitive) {
        Hit found;
        if (!IndexedPrimitives::hitsPrimitive(query, input, primitive, best.t, found)) continue;
        found.primitive = primitive;
        keepCloser(found, best);
    }
    if (best.primitive == kNoPrimitive) return false;
    hit = best;
    return true;
}

bool anyHitBruteForce(const AccelInput& input, const Ray& ray) {
    if (!RayQuery::isTraceable(ray)) return false;
    const RayQuery query(ray);
    const auto count = static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
    Hit found;
    for (std::uint32_t primitive = 0; primitive < count; ++primitive)
        if (IndexedPrimitives::hitsPrimitive(query, input, primitive, ray.tMax, found)) return true;
    return false;
}

}  // namespace rayscope::bvh
