// How one ray walks the wide tree. Include after one of the lanes_*.inl.
//
// A observer is handed on by value and told what the walk does:
//   visit(ref, search)                   a node or leaf is searched now
//   children(node, mask, entry, search)    the children whose bit is set are met, where `entry` says
//   push(ref)                             the child goes onto the stack
//   cull(ref, search)                   what waited begins behind the closest hit found since
//   filtered(block, leaf, mask, search)    of the triangles of a block those whose bit is set may be hit
//   certainHit(primitive, hit, search)      the float test is certain of a hit, which ends a search for any
//   hit;
//                                          where it is, only the observer learns
//   test(primitive, isHit, hit, search)  a primitive was tested exactly; the result is not taken up yet
#include "bvh/kernel/intersect_block.inl"
#include "bvh/kernel/intersect_node.inl"
#include "bvh/kernel/sphere.h"

namespace rayscope::bvh::kernel {
namespace {

/// What a ray has found so far.
struct QueryState {
    RayData ray;
    double scale;
    float tMin;   ///< scaled
    float bound;  ///< scaled best.t
    HitData best;

    RAYSCOPE_INLINE void keepCloser(const HitData& found) {
        if (found.t > best.t || (found.t == best.t && found.primitive > best.primitive)) return;
        best = found;
        bound = static_cast<float>(best.t * scale);
    }
};

/// Watches nothing: the walk is compiled as if there were no watchers.
struct NoObserver {};
template <class Observer>
constexpr bool isObserved = true;
template <>
constexpr bool isObserved<NoObserver> = false;

/// Tests a sphere. Returns whether it was hit.
template <class Observer = NoObserver>
RAYSCOPE_INLINE bool testSphere(const SphereRecord& record, QueryState& search, Observer observer = {}) {
    HitData found{};
    const bool isHit = hitsSphere(search.ray, record.sphere, search.best.t, found);
    if constexpr (isObserved<Observer>) observer.test(record.primitive, isHit, found, search);
    if (!isHit) return false;
    found.primitive = record.primitive;
    search.keepCloser(found);
    return true;
}

/// Tests the triangles of a block whose bit is set; there is at least one. Returns whether any was hit.
template <bool kAny, class Observer = NoObserver>
RAYSCOPE_INLINE bool testTriangles(const TriangleBlock& block, unsigned possible, const BlockRay& ray,
                                   QueryState& search, Observer observer = {}) {
    HitData found{};
    bool any = false;
    do {
        const int lane = __builtin_ctz(possible);
        possible &= possible - 1;
        const bool isHit = ray.hits(block, lane, search.best.t, found);
        if constexpr (isObserved<Observer>) observer.test(block.primitive[lane], isHit, found, search);
        if (!isHit) continue;
        if constexpr (kAny) return true;
        search.keepCloser(found);
        any = true;
    } while (possible != 0);
    return any;
}

/// Tests what a leaf holds. Returns whether anything was hit.
template <bool kAny, class Observer = NoObserver>
RAYSCOPE_INLINE bool visitLeaf(const WideTreeView& tree, FastShear& shear, ChildRef leaf, QueryState& search,
                               Observer observer = {}) {
    if (leaf >= kSphereTag) return testSphere(tree.spheres[leaf & kSphereIndexMask], search, observer);
    shear.prepareOnce(search.ray, static_cast<float>(search.scale));
    const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
    const FilterResult found = filterTriangles(block, leaf, shear, search.tMin, search.bound);
    if constexpr (isObserved<Observer>) observer.filtered(block, leaf, found.possible, search);
    if (found.possible == 0) return false;
    if constexpr (kAny) {
        const unsigned certain = found.certain();
        if constexpr (isObserved<Observer>) {
            HitData hit{};
            if (certain != 0 &&
                BlockRay(search.ray, shear).hits(block, __builtin_ctz(certain), search.best.t, hit))
                observer.certainHit(hit.primitive, hit, search);
        }
        if (certain != 0) return true;
    }
    return testTriangles<kAny>(block, found.possible, BlockRay(search.ray, shear), search, observer);
}

struct StackEntry {
    ChildRef ref;
    float entry;
};
constexpr int kStackSize = (kWidth - 1) * kMaxWideLevels + kWidth;

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
template <class Observer>
RAYSCOPE_INLINE ChildRef nearestChild(const WideTreeView& tree, const WideNode& node, unsigned mask,
                                      Lanes entry, StackEntry* stack, int& stackSize, Observer observer) {
    const int first = __builtin_ctz(mask);
    const unsigned others = mask & (mask - 1);
    if (others == 0) return node.child[first];
    alignas(32) float entries[kWidth];
    entry.store(entries);
    StackEntry* const lowest = stack + stackSize;
    ChildRef nearest;
    if ((others & (others - 1)) == 0) {
        const StackEntry one{node.child[first], entries[first]};
        const int second = __builtin_ctz(others);
        const StackEntry other{node.child[second], entries[second]};
        const bool isNearer = other.entry < one.entry;
        nearest = isNearer ? other.ref : one.ref;
        *lowest = isNearer ? one : other;
        prefetch(tree, lowest->ref);
        ++stackSize;
    } else {
        stackSize += __builtin_popcount(others);
        for (unsigned rest = mask; rest != 0; rest &= rest - 1) {
            const int lane = __builtin_ctz(rest);
            const Lanes own = Lanes::all(entries[lane]);
            const unsigned ties = lessOrEqual(entry, own) & ((1u << lane) - 1u);
            const int nearer = __builtin_popcount(mask & (less(entry, own) | ties));
            prefetch(tree, node.child[lane]);
            stack[stackSize - nearer] = {node.child[lane], entries[lane]};
        }
        nearest = stack[stackSize].ref;
    }
    if constexpr (isObserved<Observer>)
        for (StackEntry* place = lowest; place < stack + stackSize; ++place) observer.push(place->ref);
    return nearest;
}

template <class BoxLanes, class Observer = NoObserver>
RAYSCOPE_INLINE void traverseClosest(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                     FastShear& shear, QueryState& search, Observer observer = {}) {
    StackEntry stack[kStackSize];
    int stackSize = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (isObserved<Observer>) observer.visit(ref, search);
        if (ref & kTagMask) {
            visitLeaf<false>(tree, shear, ref, search, observer);
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            if constexpr (isObserved<Observer>) observer.children(node, mask, entry, search);
            if (mask != 0) {
                ref = nearestChild(tree, node, mask, entry, stack, stackSize, observer);
                continue;
            }
        }
        while (stackSize > 0 && stack[stackSize - 1].entry > search.bound) {
            --stackSize;
            if constexpr (isObserved<Observer>) observer.cull(stack[stackSize].ref, search);
        }
        if (stackSize == 0) break;
        ref = stack[--stackSize].ref;
    }
}

template <class BoxLanes, class Observer = NoObserver>
RAYSCOPE_INLINE bool traverseAny(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                 FastShear& shear, QueryState& search, Observer observer = {}) {
    ChildRef stack[kStackSize];
    int stackSize = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (isObserved<Observer>) observer.visit(ref, search);
        if (ref & kTagMask) {
            if (visitLeaf<true>(tree, shear, ref, search, observer)) return true;
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, search.bound, entry);
            if constexpr (isObserved<Observer>) observer.children(node, mask, entry, search);
            const int met = static_cast<int>(compress(mask, node.child, stack + stackSize));
            if constexpr (isObserved<Observer>)
                for (int i = 0; i < met; ++i) observer.push(stack[stackSize + i]);
            stackSize += met;
        }
        if (stackSize == 0) return false;
        ref = stack[--stackSize];
    }
}

/// Calls `walk` with the lanes that suit the ray.
template <class Walk>
RAYSCOPE_INLINE void prepared(const WideTreeView& tree, RayData ray, const Walk& walk) {
    FastRay fast;
    fast.prepare(ray);
    if (fast.suits(tree.largest)) {
        QueryState search{
            ray, fast.scale, fast.tMin, scaledTMax(ray[7], fast.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(FastBoxLanes(ray, fast), search);
    } else {
        const BoxRay box(ray);
        QueryState search{
            ray, box.scale, box.tMin, scaledTMax(ray[7], box.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        walk(ExactBoxLanes(ray, box), search);
    }
}

[[maybe_unused]] bool closestHit(const WideTreeView& tree, RayData ray, HitData& hit) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, QueryState& search) {
        FastShear shear{};
        traverseClosest(tree, tree.root, lanes, shear, search);
        found = search.best.primitive != kNoPrimitive;
        if (found) hit = search.best;
    });
    return found;
}

[[maybe_unused]] bool anyHit(const WideTreeView& tree, RayData ray) {
    if (!isTraceable(ray)) return false;
    bool found;
    prepared(tree, ray, [&](const auto& lanes, QueryState& search) {
        FastShear shear{};
        found = traverseAny(tree, tree.root, lanes, shear, search);
    });
    return found;
}

/// The search of closestHit() or anyHit(), watched; the observer learns what is found.
template <class Observer>
RAYSCOPE_INLINE void traverseObserved(const WideTreeView& tree, RayData ray, bool any, Observer observer) {
    prepared(tree, ray, [&](const auto& lanes, QueryState& search) {
        FastShear shear{};
        if (any)
            traverseAny(tree, tree.root, lanes, shear, search, observer);
        else
            traverseClosest(tree, tree.root, lanes, shear, search, observer);
    });
}

/// The same for many rays, one after the other.
[[maybe_unused]] void closestHitsSequential(const WideTreeView& tree, const float* rays, HitData* hits,
                                            size_t count) {
    for (size_t i = 0; i < count; ++i) {
        hits[i] = {kInfinity, kNoPrimitive, 0.0f, 0.0f};
        closestHit(tree, rays + 8 * i, hits[i]);
    }
}

[[maybe_unused]] void anyHitsSequential(const WideTreeView& tree, const float* rays, uint8_t* occluded,
                                        size_t count) {
    for (size_t i = 0; i < count; ++i) occluded[i] = anyHit(tree, rays + 8 * i);
}

}  // namespace
}  // namespace rayscope::bvh::kernel
