// How one ray walks the wide tree. Include after one of the lanes_*.inl.
#include "bvh/kernel/block_test.inl"
#include "bvh/kernel/node_test.inl"
#include "bvh/kernel/sphere.h"

namespace rayscope::kernel {
namespace {

/// What a ray has found so far.
struct Search {
    RayWords ray;
    double scale;
    float tMin;   ///< scaled
    float bound;  ///< scaled best.t
    HitWords best;

    RAYSCOPE_INLINE void keepCloser(const HitWords& found) {
        if (found.t > best.t || (found.t == best.t && found.primitive > best.primitive)) return;
        best = found;
        bound = static_cast<float>(best.t * scale);
    }
};

/// Tests what a leaf holds. Returns whether anything was hit.
template <bool kAny>
RAYSCOPE_INLINE bool visitLeaf(const WideTreeView& tree, const FastShear& shear, ChildRef leaf,
                               Search& search) {
    HitWords found;
    if (leaf >= kSphereTag) {
        const SphereRecord& record = tree.spheres[leaf & kSphereIndexMask];
        if (!hitsSphere(search.ray, record.sphere, search.best.t, found)) return false;
        found.primitive = record.primitive;
        search.keepCloser(found);
        return true;
    }
    const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
    bool any = false;
    for (unsigned mask = candidates(block, leaf, shear, search.tMin, search.bound); mask != 0;
         mask &= mask - 1) {
        if (!testTriangle(search.ray, block, __builtin_ctz(mask), search.best.t, found)) continue;
        if constexpr (kAny) return true;
        search.keepCloser(found);
        any = true;
    }
    return any;
}

struct Waiting {
    ChildRef ref;
    float entry;
};
constexpr int kStackSize = (kWidth - 1) * kMostWideLevels + kWidth;

/// The near child of several first; the others wait.
RAYSCOPE_INLINE ChildRef nearestChild(const WideNode& node, unsigned mask, Lanes entry, Waiting* stack,
                                      int& waiting) {
    alignas(32) float entries[kWidth];
    entry.store(entries);
    int lane = __builtin_ctz(mask);
    Waiting nearest{node.child[lane], entries[lane]};
    for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
        lane = __builtin_ctz(mask);
        const Waiting other{node.child[lane], entries[lane]};
        const bool nearer = other.entry < nearest.entry;
        stack[waiting++] = nearer ? nearest : other;
        nearest = nearer ? other : nearest;
    }
    return nearest.ref;
}

template <class BoxLanes>
RAYSCOPE_INLINE void walkToClosestHit(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                      FastShear& shear, bool& isSheared, Search& search) {
    Waiting stack[kStackSize];
    int waiting = 0;
    ChildRef ref = from;
    while (true) {
        if (ref & kTagMask) {
            if (!isSheared) {
                shear.prepare(search.ray, static_cast<float>(search.scale));
                isSheared = true;
            }
            visitLeaf<false>(tree, shear, ref, search);
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            if (mask != 0) {
                ref = nearestChild(node, mask, entry, stack, waiting);
                continue;
            }
        }
        while (waiting > 0 && stack[waiting - 1].entry > search.bound) --waiting;
        if (waiting == 0) break;
        ref = stack[--waiting].ref;
    }
}

template <class BoxLanes>
RAYSCOPE_INLINE bool walkToAnyHit(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                  FastShear& shear, bool& isSheared, Search& search) {
    ChildRef stack[kStackSize];
    int waiting = 0;
    ChildRef ref = from;
    while (true) {
        if (ref & kTagMask) {
            if (!isSheared) {
                shear.prepare(search.ray, static_cast<float>(search.scale));
                isSheared = true;
            }
            if (visitLeaf<true>(tree, shear, ref, search)) return true;
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            waiting += static_cast<int>(compress(mask, node.child, stack + waiting));
        }
        if (waiting == 0) return false;
        ref = stack[--waiting];
    }
}

/// Calls `walk` with the lanes that suit the ray.
template <class Walk>
RAYSCOPE_INLINE void prepared(const WideTreeView& tree, RayWords ray, const Walk& walk) {
    FastRay fast;
    fast.prepare(ray);
    if (fast.suits(tree.largest)) {
        Search search{ray, fast.scale, fast.tMin, fast.bound, {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(FastBoxLanes(ray, fast), search);
    } else {
        const BoxRay box(ray);
        Search search{ray, box.scale, box.tMin, box.tMax, {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(ExactBoxLanes(ray, box), search);
    }
}

bool closestHit(const WideTreeView& tree, RayWords ray, HitWords& hit) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, Search& search) {
        FastShear shear{};
        bool isSheared = false;
        walkToClosestHit(tree, tree.root, lanes, shear, isSheared, search);
        found = search.best.primitive != kNoPrimitive;
        if (found) hit = search.best;
    });
    return found;
}

bool anyHit(const WideTreeView& tree, RayWords ray) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, Search& search) {
        FastShear shear{};
        bool isSheared = false;
        found = walkToAnyHit(tree, tree.root, lanes, shear, isSheared, search);
    });
    return found;
}

}  // namespace
}  // namespace rayscope::kernel
