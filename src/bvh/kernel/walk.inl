// How one ray walks the wide tree. Include after one of the lanes_*.inl.
//
// A watcher is handed on by value and told what the walk does:
//   entered(ref, search)                   a node or leaf is searched now
//   children(node, mask, entry, search)    the children whose bit is set are met, where `entry` says
//   waits(ref)                             the child goes onto the stack
//   skipped(ref, search)                   what waited begins behind the closest hit found since
//   filtered(block, leaf, mask, search)    of the triangles of a block those whose bit is set may be hit
//   surelyHit(primitive, hit, search)      the float test is sure of a hit, which ends a search for any hit;
//                                          where it is, only the watcher learns
//   tested(primitive, isHit, hit, search)  a primitive was tested exactly; the result is not taken up yet
#include "bvh/kernel/block_test.inl"
#include "bvh/kernel/node_test.inl"
#include "bvh/kernel/sphere.h"

namespace rayscope::bvh::kernel {
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

/// Watches nothing: the walk is compiled as if there were no watchers.
struct NoWatcher {};
template <class Watcher>
constexpr bool watches = true;
template <>
constexpr bool watches<NoWatcher> = false;

/// Tests a sphere. Returns whether it was hit.
template <class Watcher = NoWatcher>
RAYSCOPE_INLINE bool testSphere(const SphereRecord& record, Search& search, Watcher watcher = {}) {
    HitWords found{};
    const bool isHit = hitsSphere(search.ray, record.sphere, search.best.t, found);
    if constexpr (watches<Watcher>) watcher.tested(record.primitive, isHit, found, search);
    if (!isHit) return false;
    found.primitive = record.primitive;
    search.keepCloser(found);
    return true;
}

/// Tests the triangles of a block whose bit is set; there is at least one. Returns whether any was hit.
template <bool kAny, class Watcher = NoWatcher>
RAYSCOPE_INLINE bool testTriangles(const TriangleBlock& block, unsigned possible, const BlockRay& ray,
                                   Search& search, Watcher watcher = {}) {
    HitWords found{};
    bool any = false;
    do {
        const int lane = __builtin_ctz(possible);
        possible &= possible - 1;
        const bool isHit = ray.hits(block, lane, search.best.t, found);
        if constexpr (watches<Watcher>) watcher.tested(block.primitive[lane], isHit, found, search);
        if (!isHit) continue;
        if constexpr (kAny) return true;
        search.keepCloser(found);
        any = true;
    } while (possible != 0);
    return any;
}

/// Tests what a leaf holds. Returns whether anything was hit.
template <bool kAny, class Watcher = NoWatcher>
RAYSCOPE_INLINE bool visitLeaf(const WideTreeView& tree, FastShear& shear, ChildRef leaf, Search& search,
                               Watcher watcher = {}) {
    if (leaf >= kSphereTag) return testSphere(tree.spheres[leaf & kSphereIndexMask], search, watcher);
    shear.prepareOnce(search.ray, static_cast<float>(search.scale));
    const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
    const Candidates found = candidates(block, leaf, shear, search.tMin, search.bound);
    if constexpr (watches<Watcher>) watcher.filtered(block, leaf, found.possible, search);
    if (found.possible == 0) return false;
    if constexpr (kAny) {
        const unsigned sure = found.sure();
        if constexpr (watches<Watcher>) {
            HitWords hit{};
            if (sure != 0 && BlockRay(search.ray, shear).hits(block, __builtin_ctz(sure), search.best.t, hit))
                watcher.surelyHit(hit.primitive, hit, search);
        }
        if (sure != 0) return true;
    }
    return testTriangles<kAny>(block, found.possible, BlockRay(search.ray, shear), search, watcher);
}

struct Waiting {
    ChildRef ref;
    float entry;
};
constexpr int kStackSize = (kWidth - 1) * kMostWideLevels + kWidth;

/// A subtree will be visited soon, but not next. Of a block the last of five cache lines can wait.
RAYSCOPE_INLINE void prefetch(const WideTreeView& tree, ChildRef ref) {
    if (ref >= kSphereTag) return;
    const bool isBlock = (ref & kTagMask) != 0;
    const auto* at = isBlock ? reinterpret_cast<const char*>(&tree.blocks[ref & kBlockIndexMask])
                             : reinterpret_cast<const char*>(&tree.nodes[ref]);
    for (size_t line = 0; line < sizeof(WideNode); line += 64) __builtin_prefetch(at + line);
}

/// The nearest child of those that are met; the others wait in order, the farthest lowest. The order of more
/// than two cannot be predicted, so there is no branch on it: the place of a child is the number of those
/// that are nearer.
template <class Watcher>
RAYSCOPE_INLINE ChildRef nearestChild(const WideTreeView& tree, const WideNode& node, unsigned mask,
                                      Lanes entry, Waiting* stack, int& waiting, Watcher watcher) {
    const int first = __builtin_ctz(mask);
    const unsigned others = mask & (mask - 1);
    if (others == 0) return node.child[first];
    alignas(32) float entries[kWidth];
    entry.store(entries);
    Waiting* const lowest = stack + waiting;
    ChildRef nearest;
    if ((others & (others - 1)) == 0) {
        const Waiting one{node.child[first], entries[first]};
        const int second = __builtin_ctz(others);
        const Waiting other{node.child[second], entries[second]};
        const bool isNearer = other.entry < one.entry;
        nearest = isNearer ? other.ref : one.ref;
        *lowest = isNearer ? one : other;
        prefetch(tree, lowest->ref);
        ++waiting;
    } else {
        waiting += __builtin_popcount(others);
        for (unsigned rest = mask; rest != 0; rest &= rest - 1) {
            const int lane = __builtin_ctz(rest);
            const Lanes own = Lanes::all(entries[lane]);
            const unsigned ties = lessOrEqual(entry, own) & ((1u << lane) - 1u);
            const int nearer = __builtin_popcount(mask & (less(entry, own) | ties));
            prefetch(tree, node.child[lane]);
            stack[waiting - nearer] = {node.child[lane], entries[lane]};
        }
        nearest = stack[waiting].ref;
    }
    if constexpr (watches<Watcher>)
        for (Waiting* place = lowest; place < stack + waiting; ++place) watcher.waits(place->ref);
    return nearest;
}

template <class BoxLanes, class Watcher = NoWatcher>
RAYSCOPE_INLINE void walkToClosestHit(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                      FastShear& shear, Search& search, Watcher watcher = {}) {
    Waiting stack[kStackSize];
    int waiting = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (watches<Watcher>) watcher.entered(ref, search);
        if (ref & kTagMask) {
            visitLeaf<false>(tree, shear, ref, search, watcher);
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            if constexpr (watches<Watcher>) watcher.children(node, mask, entry, search);
            if (mask != 0) {
                ref = nearestChild(tree, node, mask, entry, stack, waiting, watcher);
                continue;
            }
        }
        while (waiting > 0 && stack[waiting - 1].entry > search.bound) {
            --waiting;
            if constexpr (watches<Watcher>) watcher.skipped(stack[waiting].ref, search);
        }
        if (waiting == 0) break;
        ref = stack[--waiting].ref;
    }
}

template <class BoxLanes, class Watcher = NoWatcher>
RAYSCOPE_INLINE bool walkToAnyHit(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                  FastShear& shear, Search& search, Watcher watcher = {}) {
    ChildRef stack[kStackSize];
    int waiting = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (watches<Watcher>) watcher.entered(ref, search);
        if (ref & kTagMask) {
            if (visitLeaf<true>(tree, shear, ref, search, watcher)) return true;
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            if constexpr (watches<Watcher>) watcher.children(node, mask, entry, search);
            const int met = static_cast<int>(compress(mask, node.child, stack + waiting));
            if constexpr (watches<Watcher>)
                for (int i = 0; i < met; ++i) watcher.waits(stack[waiting + i]);
            waiting += met;
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
        Search search{
            ray, fast.scale, fast.tMin, scaledReach(ray[7], fast.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(FastBoxLanes(ray, fast), search);
    } else {
        const BoxRay box(ray);
        Search search{
            ray, box.scale, box.tMin, scaledReach(ray[7], box.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(ExactBoxLanes(ray, box), search);
    }
}

[[maybe_unused]] bool closestHit(const WideTreeView& tree, RayWords ray, HitWords& hit) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, Search& search) {
        FastShear shear{};
        walkToClosestHit(tree, tree.root, lanes, shear, search);
        found = search.best.primitive != kNoPrimitive;
        if (found) hit = search.best;
    });
    return found;
}

[[maybe_unused]] bool anyHit(const WideTreeView& tree, RayWords ray) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, Search& search) {
        FastShear shear{};
        found = walkToAnyHit(tree, tree.root, lanes, shear, search);
    });
    return found;
}

/// The search of closestHit() or anyHit(), watched; the watcher learns what is found.
template <class Watcher>
RAYSCOPE_INLINE void searchWatched(const WideTreeView& tree, RayWords ray, bool any, Watcher watcher) {
    prepared(tree, ray, [&](const auto& lanes, Search& search) {
        FastShear shear{};
        if (any)
            walkToAnyHit(tree, tree.root, lanes, shear, search, watcher);
        else
            walkToClosestHit(tree, tree.root, lanes, shear, search, watcher);
    });
}

/// The same for many rays, one after the other.
[[maybe_unused]] void closestHitsInTurn(const WideTreeView& tree, const float* rays, HitWords* hits,
                                        size_t count) {
    for (size_t i = 0; i < count; ++i) {
        hits[i] = {kInfinity, kNoPrimitive, 0.0f, 0.0f};
        closestHit(tree, rays + 8 * i, hits[i]);
    }
}

[[maybe_unused]] void anyHitsInTurn(const WideTreeView& tree, const float* rays, uint8_t* occluded,
                                    size_t count) {
    for (size_t i = 0; i < count; ++i) occluded[i] = anyHit(tree, rays + 8 * i);
}

}  // namespace
}  // namespace rayscope::bvh::kernel
