#include "trace/world.h"

#include "bvh/traversal/crossings.h"
#include "bvh/traversal/traverse.h"

namespace rayscope::trace {

namespace {

bool closestHitInGroup(const MotionGroup& group, bool useBvh, const Ray& ray, Hit& hit) {
    return useBvh ? group.accel->closestHit(ray, hit)
                  : bvh::closestHitBruteForce(group.geometry->input, ray, hit);
}

bool anyHitInGroup(const MotionGroup& group, bool useBvh, const Ray& ray) {
    return useBvh ? group.accel->anyHit(ray) : bvh::anyHitBruteForce(group.geometry->input, ray);
}

void crossingsInGroup(const MotionGroup& group, bool useBvh, const Ray& ray, std::vector<Hit>& found) {
    if (useBvh)
        group.accel->crossings(ray, found);
    else
        found = bvh::crossingsBruteForce(group.geometry->input, ray);
}

}  // namespace

bool World::closestHit(const Ray& ray, float time, Hit& hit) const {
    if (!moves && !motionGroups.empty()) return closestHitInGroup(motionGroups[0], settings.bvh, ray, hit);
    hit = Hit{};
    for (const MotionGroup& group : motionGroups) {
        Hit candidate;
        if (!closestHitInGroup(group, settings.bvh, group.geometry->inRestFrame(ray, time), candidate))
            continue;
        candidate.primitive += group.firstPrimitive;
        // Groups are in the order of their primitive numbers, so the first one wins a tie.
        if (candidate.t < hit.t || hit.primitive == kNoPrimitive) hit = candidate;
    }
    return hit.primitive != kNoPrimitive;
}

bool World::anyHit(const Ray& ray, float time) const {
    if (!moves) return !motionGroups.empty() && anyHitInGroup(motionGroups[0], settings.bvh, ray);
    for (const MotionGroup& group : motionGroups)
        if (anyHitInGroup(group, settings.bvh, group.geometry->inRestFrame(ray, time))) return true;
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

void World::crossings(const Ray& ray, float time, std::vector<Hit>& found) const {
    found.clear();
    std::vector<Hit> inGroup;
    for (const MotionGroup& group : motionGroups) {
        crossingsInGroup(group, settings.bvh, moves ? group.geometry->inRestFrame(ray, time) : ray, inGroup);
        for (Hit hit : inGroup) {
            hit.primitive += group.firstPrimitive;
            found.push_back(hit);
        }
    }
    bvh::sortCrossings(found);
}

PrimitiveLocation World::locatePrimitive(std::uint32_t primitive) const {
    std::size_t i = motionGroups.size() - 1;
    while (motionGroups[i].firstPrimitive > primitive) --i;
    PrimitiveLocation location;
    location.motionGroup = &motionGroups[i];
    location.inGroup = primitive - motionGroups[i].firstPrimitive;
    location.range = &motionGroups[i].geometry->objectOf(location.inGroup);
    location.inObject = location.inGroup - location.range->first;
    return location;
}

std::uint32_t World::materialOf(const PrimitiveLocation& location) const {
    const ObjectRange& range = *location.range;
    if (!range.mesh) return range.material;
    const std::size_t slot =
        range.mesh->materialSlots.empty() ? 0 : range.mesh->materialSlots[location.inObject];
    return (*range.materials)[slot];
}

std::uint32_t World::primitiveCount() const {
    if (motionGroups.empty()) return 0;
    const AccelInput& input = motionGroups.back().geometry->input;
    return motionGroups.back().firstPrimitive +
           static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
}

}  // namespace rayscope::trace
