// How many rays walk the wide tree together. Include after one of the lanes_*.inl.
//
// A stream goes down the tree once: every node is visited with the list of all rays that meet its box, so it
// is fetched once for all of them, and their tests do not wait for one another. The children's lists are
// gathered from one byte per ray; the nearest child comes first. Lists that have become short go on ray by
// ray.
#include "bvh/kernel/walk.inl"

namespace rayscope::kernel {
namespace {

constexpr uint32_t kStreamSize = 1024;
constexpr uint32_t kFewRays = 4;                      ///< fewer are not worth a stream
constexpr uint32_t kShortList = 1;                    ///< rays that go on by themselves
constexpr uint32_t kListCapacity = 16 * kStreamSize;  ///< rays in all lists that wait

/// The rays of a stream that have to visit a subtree.
struct StreamList {
    ChildRef ref;
    uint32_t begin, count;  ///< in Stream::lists
};

struct StreamRay {
    FastRay fast;
    FastShear shear;
};

template <bool kAny>
struct Stream {
    const WideTreeView& tree;
    const float* rays;  ///< eight words each
    HitWords* best;     ///< of closest-hit queries, one per ray
    uint8_t* occluded;  ///< of any-hit queries, one per ray
    StreamRay prepared[kStreamSize];
    uint8_t masks[kStreamSize + 64];
    uint32_t lists[kListCapacity + 64];

    RAYSCOPE_INLINE Stream(const WideTreeView& t, const float* r, HitWords* b, uint8_t* o)
        : tree(t), rays(r), best(b), occluded(o) {}
    RAYSCOPE_INLINE RayWords words(uint32_t ray) const { return rays + size_t{8} * ray; }

    /// Takes up a result.
    RAYSCOPE_INLINE void keep(uint32_t ray, const Search& search) {
        if constexpr (kAny) {
            occluded[ray] = 1;
            prepared[ray].fast.bound = -1.0f;
        } else {
            best[ray] = search.best;
            prepared[ray].fast.bound = search.bound;
        }
    }
    RAYSCOPE_INLINE Search searchOf(uint32_t ray) const {
        const FastRay& fast = prepared[ray].fast;
        const HitWords none{words(ray)[7], kNoPrimitive, 0.0f, 0.0f};
        return {words(ray), fast.scale, fast.tMin, fast.bound, kAny ? none : best[ray]};
    }

    RAYSCOPE_INLINE void visitLeaf(ChildRef leaf, const uint32_t* list, uint32_t count) {
        leaf < kSphereTag ? visitBlock(leaf, list, count)
                          : visitSphere(tree.spheres[leaf & kSphereIndexMask], list, count);
    }
    [[gnu::noinline]] void visitBlock(ChildRef leaf, const uint32_t* list, uint32_t count) {
        const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t ray = list[i];
            StreamRay& r = prepared[ray];
            if (kAny && r.fast.bound < 0.0f) continue;
            r.shear.prepareOnce(words(ray), r.fast.scale);
            const unsigned possible = candidates(block, leaf, r.shear, r.fast.tMin, r.fast.bound);
            if (possible == 0) continue;
            Search search = searchOf(ray);
            if (testTriangles<kAny>(block, possible, r.shear, search)) keep(ray, search);
        }
    }
    RAYSCOPE_INLINE void visitSphere(const SphereRecord& sphere, const uint32_t* list, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            if (kAny && prepared[list[i]].fast.bound < 0.0f) continue;
            Search search = searchOf(list[i]);
            if (testSphere(sphere, search)) keep(list[i], search);
        }
    }

    /// Goes on with each ray by itself.
    RAYSCOPE_INLINE void visitAlone(ChildRef ref, const uint32_t* list, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t ray = list[i];
            StreamRay& r = prepared[ray];
            if (kAny && r.fast.bound < 0.0f) continue;
            Search search = searchOf(ray);
            const FastBoxLanes lanes(search.ray, r.fast);
            if constexpr (kAny) {
                if (walkToAnyHit(tree, ref, lanes, r.shear, search)) keep(ray, search);
            } else {
                walkToClosestHit(tree, ref, lanes, r.shear, search);
                keep(ray, search);
            }
        }
    }

    /// Tests all rays of a list against a node; returns which children are met at all, and where nearest.
    RAYSCOPE_INLINE unsigned testNode(const WideNode& node, const uint32_t* list, uint32_t count,
                                      Lanes& nearest) {
        const Lanes planes[6] = {Lanes::load(node.planes[0]), Lanes::load(node.planes[1]),
                                 Lanes::load(node.planes[2]), Lanes::load(node.planes[3]),
                                 Lanes::load(node.planes[4]), Lanes::load(node.planes[5])};
        const Lanes shorter = Lanes::all(1.0f - 0x1p-20f), longer = Lanes::all(1.0f + 0x1p-20f);
        unsigned present = 0;
        for (int child = 0; child < kWidth; ++child) present |= (node.child[child] != 0 ? 1u : 0u) << child;
        unsigned any = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const FastRay& ray = prepared[list[i]].fast;
            Lanes near[3], far[3];
            for (int axis = 0; axis < 3; ++axis) {
                const Lanes inverse = Lanes::all(ray.inverse[axis]),
                            constant = Lanes::all(ray.constant[axis]);
                const Lanes a = multiplyAdd(planes[2 * axis], inverse, constant);
                const Lanes b = multiplyAdd(planes[2 * axis + 1], inverse, constant);
                near[axis] = minimum(a, b);
                far[axis] = maximum(a, b);
            }
            const Lanes pad = Lanes::all(ray.pad);
            const Lanes enter = maximum(maximum(near[0], near[1]), near[2]) * shorter - pad;
            const Lanes leave = multiplyAdd(minimum(minimum(far[0], far[1]), far[2]), longer, pad);
            const unsigned mask = lessOrEqual(maximum(enter, Lanes::all(ray.tMin)),
                                              minimum(leave, Lanes::all(ray.bound)), enter, nearest) &
                                  present;
            masks[i] = static_cast<uint8_t>(mask);
            any |= mask;
        }
        return any;
    }

    void run(uint32_t count) {
        StreamList stack[kStackSize];
        int waiting = 0;
        stack[waiting++] = {tree.root, 0, count};
        while (waiting > 0) {
            const StreamList top = stack[--waiting];
            const uint32_t* list = lists + top.begin;
            if (top.ref & kTagMask) {
                visitLeaf(top.ref, list, top.count);
                continue;
            }
            if (top.count <= kShortList || top.begin + 9 * top.count > kListCapacity) {
                visitAlone(top.ref, list, top.count);
                continue;
            }
            const WideNode& node = tree.nodes[top.ref];
            Lanes nearest = Lanes::all(kInfinity);
            unsigned any = testNode(node, list, top.count, nearest);
            if (any == 0) continue;
            alignas(32) float entries[kWidth];
            nearest.store(entries);
            uint32_t end = top.begin + top.count;
            int order[kWidth], children = 0;
            for (; any != 0; any &= any - 1) {  // far to near
                const int child = __builtin_ctz(any);
                int place = children++;
                for (; place > 0 && entries[order[place - 1]] < entries[child]; --place)
                    order[place] = order[place - 1];
                order[place] = child;
            }
            for (int i = 0; i < children; ++i) {
                const ChildRef ref = node.child[order[i]];
                prefetch(tree, ref);
                const uint32_t gathered = gatherByBit(masks, order[i], list, top.count, lists + end);
                stack[waiting++] = {ref, end, gathered};
                end += gathered;
            }
        }
    }
};

/// Prepares the rays that suit a stream, and answers the others.
template <bool kAny>
RAYSCOPE_INLINE uint32_t prepare(Stream<kAny>& stream, uint32_t count) {
    uint32_t length = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const RayWords ray = stream.words(i);
        if (!isTraceable(ray)) continue;
        StreamRay& r = stream.prepared[i];
        r.fast.prepare(ray);
        if (!r.fast.suits(stream.tree.largest)) {
            if constexpr (kAny) {
                stream.occluded[i] = anyHit(stream.tree, ray);
            } else {
                closestHit(stream.tree, ray, stream.best[i]);
            }
            continue;
        }
        r.shear.isReady = false;
        if constexpr (!kAny) stream.best[i].t = ray[7];
        stream.lists[length++] = i;
    }
    return length;
}

void closestHits(const WideTreeView& tree, const float* rays, HitWords* hits, size_t count) {
    if (count < kFewRays) return closestHitsInTurn(tree, rays, hits, count);
    for (size_t i = 0; i < count; ++i) hits[i] = {kInfinity, kNoPrimitive, 0.0f, 0.0f};
    for (size_t begin = 0; begin < count; begin += kStreamSize) {
        const size_t size = count - begin < kStreamSize ? count - begin : kStreamSize;
        Stream<false> stream(tree, rays + 8 * begin, hits + begin, nullptr);
        stream.run(prepare(stream, static_cast<uint32_t>(size)));
    }
    for (size_t i = 0; i < count; ++i)
        if (hits[i].primitive == kNoPrimitive) hits[i].t = kInfinity;
}

void anyHits(const WideTreeView& tree, const float* rays, uint8_t* occluded, size_t count) {
    if (count < kFewRays) return anyHitsInTurn(tree, rays, occluded, count);
    for (size_t i = 0; i < count; ++i) occluded[i] = 0;
    for (size_t begin = 0; begin < count; begin += kStreamSize) {
        const size_t size = count - begin < kStreamSize ? count - begin : kStreamSize;
        Stream<true> stream(tree, rays + 8 * begin, nullptr, occluded + begin);
        stream.run(prepare(stream, static_cast<uint32_t>(size)));
    }
}

}  // namespace
}  // namespace rayscope::kernel
