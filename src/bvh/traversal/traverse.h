#pragma once
// Traversal of the binary tree, and brute force without a tree.
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"
#include "bvh/intersect/ray_query.h"
#include "bvh/kernel/traversal_observer.h"

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

enum class QueryKind { Closest, Any };

/// Tests the primitives of a leaf. Returns whether the traversal ends here.
template <QueryKind kKind, class Primitives, TraversalObserver O>
RAYSCOPE_INLINE bool visitLeaf(const BinaryNode& leaf, const Primitives& primitives, const RayQuery& query,
                               Hit& best, O& observer) {
    for (std::uint32_t slot = leaf.first; slot < leaf.first + leaf.count; ++slot) {
        Hit found;
        const bool isHit = primitives.hits(query, slot, best.t, found);
        found.primitive = primitives.number(slot);
        if constexpr (isObserved<O>) observer.test(found.primitive, isHit, *hitData(&found), best.t);
        if (!isHit) continue;
        keepCloser(found, best);
        if (kKind == QueryKind::Any) return true;
    }
    return false;
}

/// Tests the box of a node against the ray up to `bound`, which is the scaled best.t.
template <TraversalObserver O>
RAYSCOPE_INLINE bool intersectNode(const BinaryTree& tree, std::uint32_t node, const BoxRay& ray, float bound,
                                   float& entry, float bestT, O& observer) {
    const bool isHit = intersectBox(planes(tree.nodes[node]), ray, bound, entry);
    if constexpr (isObserved<O>) {
        const bool isOnRay = isHit || intersectBox(planes(tree.nodes[node]), ray, ray.tMax, entry);
        if (isOnRay) observer.intersect(node, static_cast<float>(entry / ray.scale));
        if (!isOnRay) observer.miss(node, bestT);
        if (isOnRay && !isHit) observer.cull(node, bestT);
    }
    return isHit;
}

/// The traversal of the binary tree: nearer child first, the other one onto the stack. `hit` is the closest
/// hit, or for QueryKind::Any the first that is found; its default on a miss.
template <QueryKind kKind, class Primitives, TraversalObserver O = NullTraversalObserver>
bool traverse(const BinaryTree& tree, const Primitives& primitives, const Ray& ray, Hit& hit,
              O&& observer = {}) {
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

    float entry[2];
    if (!intersectNode(tree, 0, query.box, bound, entry[0], best.t, observer)) return false;
    std::uint32_t current = 0;
    while (true) {
        const BinaryNode& node = tree.nodes[current];
        if constexpr (isObserved<O>) observer.visit(current, best.t);
        if (node.isLeaf()) {
            if (visitLeaf<kKind>(node, primitives, query, best, observer)) break;
            bound = query.box.distance(best.t);
        } else {
            const bool hit0 = intersectNode(tree, node.first, query.box, bound, entry[0], best.t, observer);
            const bool hit1 =
                intersectNode(tree, node.first + 1, query.box, bound, entry[1], best.t, observer);
            if (hit0 && hit1) {
                const std::uint32_t nearer = entry[1] < entry[0] ? 1 : 0;
                stack[stackSize++] = {node.first + 1 - nearer, entry[1 - nearer]};
                if constexpr (isObserved<O>) observer.push(node.first + 1 - nearer, best.t);
                current = node.first + nearer;
                continue;
            }
            if (hit0 || hit1) {
                current = hit0 ? node.first : node.first + 1;
                continue;
            }
        }
        while (stackSize > 0 && stack[stackSize - 1].entry > bound) {
            --stackSize;
            if constexpr (isObserved<O>) observer.cull(stack[stackSize].node, best.t);
        }
        if (stackSize == 0) break;
        current = stack[--stackSize].node;
    }
    if (best.primitive == kNoPrimitive) return false;
    hit = best;
    return true;
}

/// The same over the primitives of the caller.
template <QueryKind kKind, TraversalObserver O = NullTraversalObserver>
bool traverse(const BinaryTree& tree, const AccelInput& input, const Ray& ray, Hit& hit, O&& observer = {}) {
    return traverse<kKind>(tree, IndexedPrimitives{input, tree.primitives}, ray, hit, observer);
}

/// Tests every primitive. Same hits as Accel, bit for bit.
bool closestHitBruteForce(const AccelInput& input, const Ray& ray, Hit& hit);
bool anyHitBruteForce(const AccelInput& input, const Ray& ray);

}  // namespace rayscope::bvh
