#pragma once
// How a ray walks the binary tree, and the brute-force twin that needs no tree.
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"
#include "bvh/intersect/ray_query.h"
#include "bvh/traversal/traversal_observer.h"

namespace rayscope::bvh {

/// Fetches primitives through the caller's index arrays.
struct IndexedPrimitives {
    const AccelInput& input;
    const base::BigVector<std::uint32_t>& order;  ///< BinaryTree::primitives

    std::uint32_t number(std::uint32_t slot) const { return order[slot]; }
    bool hits(const RayQuery& query, std::uint32_t slot, float bound, Hit& found) const {
        return hitsPrimitive(query, input, order[slot], bound, found);
    }
    static bool hitsPrimitive(const RayQuery& query, const AccelInput& input, std::uint32_t primitive,
                              float bound, Hit& found) {
        if (primitive >= input.triangles.size())
            return query.hits(input.spheres[primitive - input.triangles.size()], bound, found);
        const glm::uvec3& corner = input.triangles[primitive];
        return query.hits(input.vertices[corner.x], input.vertices[corner.y], input.vertices[corner.z], bound,
                          found);
    }
};

/// A box was not hit within the running bound: is it behind a closer hit, or off the ray?
template <TraversalObserver O>
void reportMissOrCull(const BinaryTree& tree, std::uint32_t node, const BoxRay& ray, float t, O& observer) {
    float entry;
    if (intersectBox(planes(tree.nodes[node]), ray, ray.tMax, entry)) {
        observer.cull(node, t);
    } else {
        observer.miss(node);
    }
}

/// The one walk: near child first, the far one waits on a stack that the bounded depth of the tree limits.
template <class Primitives, TraversalObserver O>
bool traverseClosest(const BinaryTree& tree, const Primitives& primitives, const Ray& ray, Hit& hit,
                     O& observer) {
    hit = Hit{};
    if (tree.nodes.empty() || !RayQuery::isTraceable(ray)) return false;
    const RayQuery query(ray);
    struct StackEntry {
        std::uint32_t node;
        float entry;
    } stack[kMaxTreeLevel];
    int stackSize = 0;
    Hit best;
    best.t = ray.tMax;
    float bound = query.box.tMax;  // best.t as a distance of the box test

    float rootEntry;
    if (!intersectBox(planes(tree.nodes[0]), query.box, bound, rootEntry)) {
        observer.miss(0);
        return false;
    }
    std::uint32_t current = 0;
    while (true) {
        const BinaryNode& node = tree.nodes[current];
        observer.visit(current, best.t);
        if (node.isLeaf()) {
            for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
                Hit found;
                const bool isHit = primitives.hits(query, slot, best.t, found);
                observer.test(primitives.number(slot), isHit);
                if (!isHit) continue;
                found.primitive = primitives.number(slot);
                keepCloser(found, best);
            }
            bound = query.box.distance(best.t);
        } else {
            float entry[2];
            const bool hit0 = intersectBox(planes(tree.nodes[node.first]), query.box, bound, entry[0]);
            const bool hit1 = intersectBox(planes(tree.nodes[node.first + 1]), query.box, bound, entry[1]);
            if (!hit0) reportMissOrCull(tree, node.first, query.box, best.t, observer);
            if (!hit1) reportMissOrCull(tree, node.first + 1, query.box, best.t, observer);
            if (hit0 && hit1) {
                const std::uint32_t nearer = entry[1] < entry[0] ? 1 : 0;
                stack[stackSize++] = {node.first + 1 - nearer, entry[1 - nearer]};
                current = node.first + nearer;
                continue;
            }
            if (hit0 || hit1) {
                current = hit0 ? node.first : node.first + 1;
                continue;
            }
        }
        while (stackSize > 0 && stack[stackSize - 1].entry > bound)
            observer.cull(stack[--stackSize].node, best.t);
        if (stackSize == 0) break;
        current = stack[--stackSize].node;
    }
    if (best.primitive == kNoPrimitive) return false;
    hit = best;
    return true;
}

/// The walk of Accel::closestHit over the binary tree, watched. Same hit, bit for bit.
template <TraversalObserver O>
bool closestHit(const BinaryTree& tree, const AccelInput& input, const Ray& ray, Hit& hit, O& observer) {
    return traverseClosest(tree, IndexedPrimitives{input, tree.primitives}, ray, hit, observer);
}

/// Whether any primitive is hit in (tMin, tMax]. The order of the search does not matter here.
template <class Primitives>
bool traverseAny(const BinaryTree& tree, const Primitives& primitives, const Ray& ray) {
    if (tree.nodes.empty() || !RayQuery::isTraceable(ray)) return false;
    const RayQuery query(ray);
    std::uint32_t stack[kMaxTreeLevel + 1] = {0};
    int stackSize = 1;
    float entry;
    while (stackSize > 0) {
        const BinaryNode& node = tree.nodes[stack[--stackSize]];
        if (!intersectBox(planes(node), query.box, query.box.tMax, entry)) continue;
        if (node.isLeaf()) {
            Hit found;
            for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot)
                if (primitives.hits(query, slot, ray.tMax, found)) return true;
        } else {
            stack[stackSize++] = node.first + 1;
            stack[stackSize++] = node.first;
        }
    }
    return false;
}

/// Tests every primitive. Same answers as Accel, bit for bit.
bool closestHitBruteForce(const AccelInput& input, const Ray& ray, Hit& hit);
bool anyHitBruteForce(const AccelInput& input, const Ray& ray);

}  // namespace rayscope::bvh
