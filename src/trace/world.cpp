#include "trace/world.h"

#include "bvh/traversal/traverse.h"

namespace rayscope::trace {

namespace {

/// The ray in the frame in which the body rests.
Ray atRest(const Ray& ray, const Body& body, float time) {
    Ray moved = ray;
    moved.origin =
        glm::vec3(glm::dvec3(ray.origin) - static_cast<double>(time) * glm::dvec3(body.geometry->motion));
    return moved;
}

bool closestHitInBody(const Body& body, bool useBvh, const Ray& ray, Hit& hit) {
    return useBvh ? body.accel->closestHit(ray, hit)
                  : bvh::closestHitBruteForce(body.geometry->input, ray, hit);
}

bool anyHitInBody(const Body& body, bool useBvh, const Ray& ray) {
    return useBvh ? body.accel->anyHit(ray) : bvh::anyHitBruteForce(body.geometry->input, ray);
}

}  // namespace

bool World::closestHit(const Ray& ray, float time, Hit& hit) const {
    if (!moves && !bodies.empty()) return closestHitInBody(bodies[0], settings.bvh, ray, hit);
    hit = Hit{};
    for (const Body& body : bodies) {
        Hit candidate;
        if (!closestHitInBody(body, settings.bvh, atRest(ray, body, time), candidate)) continue;
        candidate.primitive += body.firstPrimitive;
        // Bodies come in the order of their primitive numbers, so the first one keeps a tie.
        if (candidate.t < hit.t || hit.primitive == kNoPrimitive) hit = candidate;
    }
    return hit.primitive != kNoPrimitive;
}

bool World::anyHit(const Ray& ray, float time) const {
    if (!moves) return !bodies.empty() && anyHitInBody(bodies[0], settings.bvh, ray);
    for (const Body& body : bodies)
        if (anyHitInBody(body, settings.bvh, atRest(ray, body, time))) return true;
    return false;
}

void World::closestHits(std::span<const Ray> rays, float time, std::span<Hit> hits) const {
    if (!moves && settings.bvh && !bodies.empty()) return bodies[0].accel->closestHits(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) closestHit(rays[i], time, hits[i]);
}

void World::anyHits(std::span<const Ray> rays, float time, std::span<std::uint8_t> occluded) const {
    if (!moves && settings.bvh && !bodies.empty()) return bodies[0].accel->anyHits(rays, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = anyHit(rays[i], time);
}

PrimitiveName World::nameOf(std::uint32_t primitive) const {
    std::size_t i = bodies.size() - 1;
    while (bodies[i].firstPrimitive > primitive) --i;
    PrimitiveName name;
    name.body = &bodies[i];
    name.inBody = primitive - bodies[i].firstPrimitive;
    name.range = &bodies[i].geometry->objectOf(name.inBody);
    name.inObject = name.inBody - name.range->first;
    return name;
}

std::uint32_t World::materialOf(const PrimitiveName& name) const {
    const ObjectRange& range = *name.range;
    if (!range.mesh) return range.material;
    const std::size_t slot = range.mesh->materialSlots.empty() ? 0 : range.mesh->materialSlots[name.inObject];
    return (*range.materials)[slot];
}

std::uint32_t World::primitiveCount() const {
    if (bodies.empty()) return 0;
    const AccelInput& input = bodies.back().geometry->input;
    return bodies.back().firstPrimitive +
           static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
}

}  // namespace rayscope::trace
