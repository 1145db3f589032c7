// Traversal of the wide tree by one ray. Include after one of the lanes_*.inl.
//
// Observers are TraversalObserver; without one the code is that of production rays.
#include "bvh/kernel/intersect_block.inl"
#include "bvh/kernel/intersect_node.inl"
#include "bvh/kernel/sphere.h"
#include "bvh/kernel/traversal_observer.h"

namespace rayscope::bvh::kernel {
namespace {

/// A ray and its closest hit so far.
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

/// Tests a sphere. Returns whether it was hit.
template <TraversalObserver O = NullTraversalObserver>
RAYSCOPE_INLINE bool testSphere(const SphereRecord& record, QueryState& state, O&& observer = {}) {
    HitData found{};
    const bool isHit = hitsSphere(state.ray, record.sphere, state.best.t, found);
    found.primitive = record.primitive;
    if constexpr (isObserved<O>) observer.test(record.primitive, isHit, found, state.best.t);
    if (!isHit) return false;
    state.keepCloser(found);
    return true;
}

/// Tests the triangles of a block whose bit in `possible` is set; there is at least one. Returns whether any
/// was hit.
template <bool kAny, TraversalObserver O = NullTraversalObserver>
RAYSCOPE_INLINE bool testTriangles(const TriangleBlock& block, unsigned possible, const BlockRay& ray,
                                   QueryState& state, O&& observer = {}) {
    HitData found{};
    bool any = false;
    do {
        const int lane = __builtin_ctz(possible);
        possible &= possible - 1;
        const bool isHit = ray.hits(block, lane, state.best.t, found);
        if constexpr (isObserved<O>) observer.test(block.primitive[lane], isHit, found, state.best.t);
        if (!isHit) continue;
        if constexpr (kAny) return true;
        state.keepCloser(found);
        any = true;
    } while (possible != 0);
    return any;
}

/// Reports what the float test of a block decides without the exact one.
template <bool kAny, TraversalObserver O>
RAYSCOPE_INLINE void reportFilter(const TriangleBlock& block, ChildRef leaf, const FilterResult& found,
                                  const FastShear& shear, const QueryState& state, O& observer) {
    for (uint32_t lane = 0; lane < trianglesIn(leaf); ++lane)
        if ((found.possible >> lane & 1u) == 0) observer.filter(block.primitive[lane], state.best.t);
    if (!kAny || found.certain() == 0) return;
    HitData hit{};
    if (BlockRay(state.ray, shear).hits(block, __builtin_ctz(found.certain()), state.best.t, hit))
        observer.certainHit(hit.primitive, hit, state.best.t);
}

/// Tests the primitives of a leaf. Returns whether any was hit.
template <bool kAny, TraversalObserver O>
RAYSCOPE_INLINE bool visitLeaf(const WideTreeView& tree, FastShear& shear, ChildRef leaf, QueryState& state,
                               O& observer) {
    if (leaf >= kSphereTag) return testSphere(tree.spheres[leaf & kSphereIndexMask], state, observer);
    shear.prepareOnce(state.ray, static_cast<float>(state.scale));
    const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
    const FilterResult found = filterTriangles(block, leaf, shear, state.tMin, state.bound);
    if constexpr (isObserved<O>) reportFilter<kAny>(block, leaf, found, shear, state, observer);
    if (found.possible == 0) return false;
    if constexpr (kAny)
        if (found.certain() != 0) return true;
    return testTriangles<kAny>(block, found.possible, BlockRay(state.ray, shear), state, observer);
}

/// Reports the box tests of the children of a node: where the bit in `mask` is set the box was hit at
/// `entry`, scaled. For the others the exact test decides whether they are missed or begin behind the closest
/// hit.
template <TraversalObserver O>
RAYSCOPE_INLINE void reportChildren(const WideNode& node, unsigned mask, Lanes entry, const QueryState& state,
                                    O& observer) {
    alignas(32) float entries[kWidth];
    entry.store(entries);
    const BoxRay ray(state.ray);
    const auto& planes = node.planes;
    for (int lane = 0; lane < kWidth; ++lane) {
        const bool isPresent = planes[0][lane] <= planes[1][lane];
        if (!isPresent) continue;
        const ChildRef child = node.child[lane];
        if ((mask >> lane & 1u) != 0) {
            observer.intersect(child, static_cast<float>(entries[lane] / state.scale));
            continue;
        }
        const Float4 lower{planes[0][lane], planes[2][lane], planes[4][lane], 0.0f},
            upper{planes[1][lane], planes[3][lane], planes[5][lane], 0.0f};
        float at;
        if (intersectBox(lower, upper, ray, ray.tMax, at)) {
            observer.intersect(child, static_cast<float>(at / ray.scale));
            observer.cull(child, state.best.t);
        } else {
            observer.miss(child, state.best.t);
        }
    }
}

struct StackEntry {
    ChildRef ref;
    float entry;
};
constexpr int kStackSize = (kWidth - 1) * kMaxWideLevels + kWidth;

/// For a subtree that is visited soon, but not next. The last of the five cache lines of a block is not
/// fetched.
RAYSCOPE_INLINE void prefetch(const WideTreeView& tree, ChildRef ref) {
    if (ref >= kSphereTag) return;
    const bool isBlock = (ref & kTagMask) != 0;
    const auto* at = isBlock ? reinterpret_cast<const char*>(&tree.blocks[ref & kBlockIndexMask])
                             : reinterpret_cast<const char*>(&tree.nodes[ref]);
    for (size_t line = 0; line < sizeof(WideNode); line += 64) __builtin_prefetch(at + line);
}

/// The nearest of the children that are hit; pushes the others in order, the farthest lowest. The order of
/// more than two is unpredictable, so there is no branch on it: the position of a child is the number of
/// nearer ones.
RAYSCOPE_INLINE ChildRef nearestChild(const WideTreeView& tree, const WideNode& node, unsigned mask,
                                      Lanes entry, StackEntry* stack, int& stackSize) {
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
            const Lanes own = Lanes::broadcast(entries[lane]);
            const unsigned ties = lessOrEqual(entry, own) & ((1u << lane) - 1u);
            const int nearer = __builtin_popcount(mask & (less(entry, own) | ties));
            prefetch(tree, node.child[lane]);
            stack[stackSize - nearer] = {node.child[lane], entries[lane]};
        }
        nearest = stack[stackSize].ref;
    }
    return nearest;
}

/// Children in order of distance; nodes behind the closest hit are culled when they are popped.
template <class BoxLanes, TraversalObserver O = NullTraversalObserver>
RAYSCOPE_INLINE void traverseClosest(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                     FastShear& shear, QueryState& state, O&& observer = {}) {
    StackEntry stack[kStackSize];
    int stackSize = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (isObserved<O>) observer.visit(ref, state.best.t);
        if (ref & kTagMask) {
            visitLeaf<false>(tree, shear, ref, state, observer);
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, state.bound, entry);
            if constexpr (isObserved<O>) reportChildren(node, mask, entry, state, observer);
            if (mask != 0) {
                [[maybe_unused]] const int sizeBefore = stackSize;
                ref = nearestChild(tree, node, mask, entry, stack, stackSize);
                if constexpr (isObserved<O>)
                    for (int i = sizeBefore; i < stackSize; ++i) observer.push(stack[i].ref, state.best.t);
                continue;
            }
        }
        while (stackSize > 0 && stack[stackSize - 1].entry > state.bound) {
            --stackSize;
            if constexpr (isObserved<O>) observer.cull(stack[stackSize].ref, state.best.t);
        }
        if (stackSize == 0) break;
        ref = stack[--stackSize].ref;
    }
}

/// Children in any order, up to the first hit.
template <class BoxLanes, TraversalObserver O = NullTraversalObserver>
RAYSCOPE_INLINE bool traverseAny(const WideTreeView& tree, ChildRef from, const BoxLanes& lanes,
                                 FastShear& shear, QueryState& state, O&& observer = {}) {
    ChildRef stack[kStackSize];
    int stackSize = 0;
    ChildRef ref = from;
    while (true) {
        if constexpr (isObserved<O>) observer.visit(ref, state.best.t);
        if (ref & kTagMask) {
            if (visitLeaf<true>(tree, shear, ref, state, observer)) return true;
        } else {
            const WideNode& node = tree.nodes[ref];
            Lanes entry;
            const unsigned mask = intersectChildren(node, lanes, state.bound, entry);
            const int pushed = static_cast<int>(compress(mask, node.child, stack + stackSize));
            if constexpr (isObserved<O>) {
                reportChildren(node, mask, entry, state, observer);
                for (int i = 0; i < pushed; ++i) observer.push(stack[stackSize + i], state.best.t);
            }
            stackSize += pushed;
        }
        if (stackSize == 0) return false;
        ref = stack[--stackSize];
    }
}

/// Calls `traverse` with a query and the ray in all lanes, prepared in float where its numbers are in range.
template <class Traverse>
RAYSCOPE_INLINE void withPreparedRay(const WideTreeView& tree, RayData ray, const Traverse& traverse) {
    FastRay fast;
    fast.prepare(ray);
    if (fast.isInRange(tree.maxCoordinate)) {
        QueryState state{
            ray, fast.scale, fast.tMin, scaledTMax(ray[7], fast.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        traverse(FastBoxLanes(ray, fast), state);
    } else {
        const BoxRay box(ray);
        QueryState state{
            ray, box.scale, box.tMin, scaledTMax(ray[7], box.scale), {ray[7], kNoPrimitive, 0.0f, 0.0f}};
        traverse(ExactBoxLanes(ray, box), state);
    }
}

/// The traversal of closestHit() or anyHit() with an observer, which receives the hit. Returns whether there
/// is one. The ray must be traceable.
template <TraversalObserver O>
RAYSCOPE_INLINE bool traverseObserved(const WideTreeView& tree, RayData ray, bool any, O& observer) {
    bool found;
    withPreparedRay(tree, ray, [&](const auto& lanes, QueryState& state) {
        FastShear shear{};
        if (any) {
            found = traverseAny(tree, tree.root, lanes, shear, state, observer);
        } else {
            traverseClosest(tree, tree.root, lanes, shear, state, observer);
            found = state.best.primitive != kNoPrimitive;
        }
    });
    return found;
}

}  // namespace
}  // namespace rayscope::bvh::kernel
