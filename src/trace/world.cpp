#include "trace/world.h"

#include "bvh/traversal/traverse.h"

namespace rayscope::trace {

namespace {

bool closestHitInGroup(const MotionGroup& motionGroup, bool useBvh, const Ray& ray, Hit& hit) {
    return useBvh ? motionGroup.accel->closestHit(ray, hit)
                  : bvh::closestHitBruteForce(motionGroup.geometry->input, ray, hit);
}

bool anyHitInGroup(const MotionGroup& motionGroup, bool useBvh, const Ray& ray) {
    return useBvh ? motionGroup.accel->anyHit(ray) : bvh::anyHitBruteForce(motionGroup.geometry->input, ray);
}

}  // namespace

bool World::closestHit(const Ray& ray, float time, Hit& hit) const {
    if (!moves && !motionGroups.empty()) return closestHitInGroup(motionGroups[0], settings.bvh, ray, hit);
    hit = Hit{};
    for (const MotionGroup& motionGroup : motionGroups) {
        Hit candidate;
        if (!closestHitInGroup(motionGroup, settings.bvh, motionGroup.geometry->inRestFrame(ray, time),
                               candidate))
            continue;
        candidate.primitive += motionGroup.firstPrimitive;
        // Bodies come in the order of their primitive numbers, so the first one keeps a tie.
        if (candidate.t < hit.t || hit.primitive == kNoPrimitive) hit = candidate;
    }
    return hit.primitive != kNoPrimitive;
}

bool World::anyHit(const Ray& ray, float time) const {
    if (!moves) return !motionGroups.empty() && anyHitInGroup(motionGroups[0], settings.bvh, ray);
    for (const MotionGroup& motionGroup : motionGroups)
        if (anyHitInGroup(motionGroup, settings.bvh, motionGroup.geometry->inRestFrame(ray, time)))
            return true;
    return false;
}

void World::closestHits(std::span<const Ray> rays, float time, std::span<Hit> hits) const {
    if (!moves && settings.bvh && !motionGroups.empty())
        return motionGroups[0].accel->closestHits(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) closestHit(rays[i], time, hits[i]);
}

void World::anyHits(std::span<const Ray> rays, float time, std::span<std::uint8_t> occluded) const {
    if (!moves && settings.bvh && !motionGroups.empty())
        return motionGroups[0].accel->anyHits(rays, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = anyHit(rays[i], time);
}

PrimitiveLocation World::nameOf(std::uint32_t primitive) const {
    std::size_t i = motionGroups.size() - 1;
    while (motionGroups[i].firstPrimitive > primitive) --i;
    PrimitiveLocation name;
    name.motionGroup = &motionGroups[i];
    name.inGroup = primitive - motionGroups[i].firstPrimitive;
    name.range = &motionGroups[i].geometry->objectOf(name.inGroup);
    name.inObject = name.inGroup - name.range->first;
    return name;
}

std::uint32_t World::materialOf(const PrimitiveLocation& name) const {
    const ObjectRange& range = *name.range;
    if (!range.mesh) return range.material;
    const std::size_t slot = range.mesh->materialSlots.empty() ? 0 : range.mesh->materialSlots[name.inObject];
    return (*range.materials)[slot];
}

std::uint32_t World::primitiveCount() const {
    if (motionGroups.empty()) return 0;
    const AccelInput& input = motionGroups.back().geometry->input;
    return motionGroups.back().firstPrimitive +
           static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
}

}  // namespace rayscope::trace
