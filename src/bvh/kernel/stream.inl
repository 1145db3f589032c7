// Traversal of the wide tree by a stream of rays. Include after one of the lanes_*.inl.
//
// A stream traverses the tree once: every node is visited with the list of all rays that hit its box, so that
// it is fetched once for all of them and their tests are independent. The lists of the children are gathered
// from one byte per ray; the nearest child is visited first. Rays of short lists are traversed one by one.
// Coherent rays are traversed as packets, which are split when too few rays of a packet hit the same leaves.
#include "bvh/kernel/stream_rays.inl"

namespace rayscope::bvh::kernel {
namespace {

constexpr uint32_t kMaxPackets = kStreamSize / kPacketSize;
constexpr uint32_t kMinStreamRays = 4;                ///< for a stream; fewer are traversed one by one
constexpr uint32_t kMaxSingleRays = 1;                ///< lists up to this length are traversed ray by ray
constexpr uint32_t kListCapacity = 32 * kStreamSize;  ///< rays and packets in all lists on the stack
constexpr int kCoherenceBudget = 16;                  ///< initial and maximum
constexpr int kMinActiveRays = 4;                     ///< of a packet at a leaf, to break even
constexpr int kMinGroupRays = 3;                      ///< for testing a group of eight rays together

/// The rays or packets of a stream that visit a subtree: a child of a node, or the root.
struct StreamList {
    ChildRef ref;
    uint32_t begin, count;  ///< in Stream::lists
    bool arePackets;
    const WideNode* parent;
    int child;
};

template <bool kAny>
struct Stream {
    const WideTreeView& tree;
    StreamRays<kAny> rays;
    Packet packets[kMaxPackets];
    /// Of packets: rays that hit leaves, minus kMinActiveRays for each visit of a packet to a leaf.
    int coherenceBudget = kCoherenceBudget;
    uint8_t masks[kStreamSize + 64];
    uint32_t lists[kListCapacity + kStreamSize + 64];  ///< with room for split packets

    RAYSCOPE_INLINE Stream(const WideTreeView& t, const float* data, HitData* best, uint8_t* occluded)
        : tree(t), rays(t, data, best, occluded) {}

    /// Rays that are not in the range of FastRay are traversed one by one.
    RAYSCOPE_INLINE void traverse(uint32_t count) {
        struct PacketInfo {
            unsigned usable;  ///< a bit for each ray
            bool isPacket;
        } infos[kMaxPackets];
        uint32_t gathered = 0;
        for (uint32_t first = 0; first < count; first += kPacketSize) {
            const uint32_t size = count - first < kPacketSize ? count - first : kPacketSize;
            Packet& packet = packets[gathered];
            const unsigned usable = rays.prepare(first, size, packet);
            for (unsigned others = ~usable & ((1u << size) - 1u); others != 0; others &= others - 1)
                rays.queryOne(first + static_cast<uint32_t>(__builtin_ctz(others)));
            const bool isPacket = usable == (1u << kPacketSize) - 1u && (tree.root & kTagMask) == 0 &&
                                  packet.gather(rays.rayData(first), rays.prepared + first, first);
            infos[first / kPacketSize] = {usable, isPacket};
            gathered += isPacket ? 1 : 0;
        }
        if (gathered * kPacketSize < count / 2) gathered = 0;
        uint32_t loose = 0;
        for (uint32_t first = 0; first < count; first += kPacketSize) {
            const PacketInfo& info = infos[first / kPacketSize];
            if (info.isPacket && gathered > 0) continue;
            for (uint32_t i = 0; i < kPacketSize; ++i) {
                lists[loose] = first + i;
                loose += info.usable >> i & 1u;
            }
        }
        run(loose, gathered);
    }

    void run(uint32_t rayCount, uint32_t packetCount) {
        StreamList stack[kStackSize + 1];
        int stackSize = 0;
        for (uint32_t i = 0; i < packetCount; ++i) lists[rayCount + i] = i;
        stack[stackSize++] = {tree.root, 0, rayCount, false, nullptr, 0};
        stack[stackSize++] = {tree.root, rayCount, packetCount, true, nullptr, 0};
        while (stackSize > 0) {
            StreamList top = stack[--stackSize];
            if (top.count == 0) continue;
            if (top.ref & kTagMask) {
                top.arePackets ? visitLeafWithPackets(top)
                               : rays.visitLeaf(top.ref, lists + top.begin, top.count);
                continue;
            }
            if (top.arePackets && (coherenceBudget < 0 || exceedsCapacity(top))) top = splitPackets(top);
            const uint32_t* list = lists + top.begin;
            if (!top.arePackets && (top.count <= kMaxSingleRays || exceedsCapacity(top))) {
                rays.traverseSingleRays(top.ref, list, top.count);
                continue;
            }
            const WideNode& node = tree.nodes[top.ref];
            Lanes nearest = Lanes::broadcast(kInfinity);
            unsigned any = top.arePackets ? testPackets(node, list, top.count, nearest)
                                          : testRays(node, list, top.count, nearest);
            if (any == 0) continue;
            alignas(32) float entries[kWidth];
            nearest.store(entries);
            uint32_t end = top.begin + top.count;
            int order[kWidth], children = 0;
            for (; any != 0; any &= any - 1) {  // far to near
                const int child = __builtin_ctz(any);
                int position = children++;
                for (; position > 0 && entries[order[position - 1]] < entries[child]; --position)
                    order[position] = order[position - 1];
                order[position] = child;
            }
            for (int i = 0; i < children; ++i) {
                const ChildRef ref = node.child[order[i]];
                prefetch(tree, ref);
                const uint32_t gathered = gatherByBit(masks, order[i], list, top.count, lists + end);
                stack[stackSize++] = {ref, end, gathered, top.arePackets, &node, order[i]};
                end += gathered;
            }
        }
    }

    /// Tests all rays of a list against a node; returns which children any of them hits, and lowers
    /// `nearest`.
    RAYSCOPE_INLINE unsigned testRays(const WideNode& node, const uint32_t* list, uint32_t count,
                                      Lanes& nearest) {
        const Lanes planes[6] = {Lanes::load(node.planes[0]), Lanes::load(node.planes[1]),
                                 Lanes::load(node.planes[2]), Lanes::load(node.planes[3]),
                                 Lanes::load(node.planes[4]), Lanes::load(node.planes[5])};
        const Lanes shorter = Lanes::broadcast(1.0f - 0x1p-20f), longer = Lanes::broadcast(1.0f + 0x1p-20f);
        unsigned present = 0;
        for (int child = 0; child < kWidth; ++child) present |= (node.child[child] != 0 ? 1u : 0u) << child;
        unsigned any = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const PackedRay& ray = rays.prepared[list[i]];
            Lanes near[3], far[3];
            for (int axis = 0; axis < 3; ++axis) {
                const Lanes inverse = Lanes::broadcast(ray.inverse[axis]),
                            constant = Lanes::broadcast(ray.constant[axis]);
                const Lanes a = multiplyAdd(planes[2 * axis], inverse, constant);
                const Lanes b = multiplyAdd(planes[2 * axis + 1], inverse, constant);
                near[axis] = minimum(a, b);
                far[axis] = maximum(a, b);
            }
            const Lanes pad = Lanes::broadcast(ray.pad);
            const Lanes enter = maximum(maximum(near[0], near[1]), near[2]) * shorter - pad;
            const Lanes leave = multiplyAdd(minimum(minimum(far[0], far[1]), far[2]), longer, pad);
            const unsigned mask =
                lessOrEqual(maximum(enter, Lanes::broadcast(ray.tMin)),
                            minimum(leave, Lanes::broadcast(rays.bounds[list[i]])), enter, nearest) &
                present;
            masks[i] = static_cast<uint8_t>(mask);
            any |= mask;
        }
        return any;
    }

    /// The same for packets.
    RAYSCOPE_INLINE unsigned testPackets(const WideNode& node, const uint32_t* list, uint32_t count,
                                         Lanes& nearest) {
        unsigned any = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const unsigned mask = packets[list[i]].intersects(node, nearest);
            masks[i] = static_cast<uint8_t>(mask);
            any |= mask;
        }
        return any;
    }

    /// Whether there may be no room for the lists of eight children.
    RAYSCOPE_INLINE static bool exceedsCapacity(const StreamList& list) {
        return list.begin + (1 + kWidth) * list.count > kListCapacity;
    }

    /// A list of the rays of packets, after their own list.
    RAYSCOPE_INLINE StreamList splitPackets(const StreamList& list) {
        StreamList rayList{list.ref, list.begin + list.count, 0, false, nullptr, 0};
        for (uint32_t i = 0; i < list.count; ++i)
            for (uint32_t k = 0; k < kPacketSize; ++k) {
                const uint32_t ray = packets[lists[list.begin + i]].firstRay + k;
                lists[rayList.begin + rayList.count] = ray;
                rayList.count += rays.isDone(ray) ? 0 : 1;
            }
        return rayList;
    }

    /// Tests the rays of packets against the box of a leaf, and those that hit it against its primitives.
    [[gnu::noinline]] void visitLeafWithPackets(const StreamList& top) {
        for (uint32_t i = 0; i < top.count; ++i) {
            Packet& packet = packets[lists[top.begin + i]];
            if (packet.bound < 0.0f) continue;
            coherenceBudget -= kMinActiveRays;
            for (uint32_t group = 0; group < kPacketGroups; ++group) {
                const uint32_t first = packet.firstRay + kWidth * group;
                unsigned hits = packet.intersects(*top.parent, top.child, group, rays.bounds + first);
                coherenceBudget += __builtin_popcount(hits);
                if (top.ref < kSphereTag && __builtin_popcount(hits) >= kMinGroupRays) {
                    visitBlockWithGroup(top.ref, packet, group, hits);
                } else {
                    for (; hits != 0; hits &= hits - 1) {
                        const uint32_t ray = first + static_cast<uint32_t>(__builtin_ctz(hits));
                        rays.visitLeaf(top.ref, &ray, 1);
                    }
                }
            }
            Lanes farthest = Lanes::load(rays.bounds + packet.firstRay);
            for (uint32_t group = 1; group < kPacketGroups; ++group)
                farthest = maximum(farthest, Lanes::load(rays.bounds + packet.firstRay + kWidth * group));
            packet.bound = horizontalMax(farthest);
            coherenceBudget = coherenceBudget < kCoherenceBudget ? coherenceBudget : kCoherenceBudget;
        }
    }
    RAYSCOPE_INLINE void visitBlockWithGroup(ChildRef leaf, Packet& packet, uint32_t group, unsigned hits) {
        const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
        const uint32_t first = packet.firstRay + kWidth * group;
        const RayColumns& columns = packet.sheared(group);
        const Lanes bound = Lanes::load(rays.bounds + first);
        uint8_t possible[kWidth] = {};
        for (uint32_t triangle = 0; triangle < trianglesIn(leaf); ++triangle) {
            const FilterResult found =
                filterTriangles(block, static_cast<int>(triangle), columns, packet.axes, bound, hits);
            unsigned hit = found.possible;
            if (kAny && hit != 0) {
                unsigned certain = found.certain();
                hits &= ~certain;
                hit &= ~certain;
                for (; certain != 0; certain &= certain - 1)
                    rays.occlude(first + static_cast<uint32_t>(__builtin_ctz(certain)));
            }
            for (; hit != 0; hit &= hit - 1)
                possible[__builtin_ctz(hit)] |= static_cast<uint8_t>(1u << triangle);
        }
        for (; hits != 0; hits &= hits - 1) {
            const int lane = __builtin_ctz(hits);
            const uint32_t ray = first + static_cast<uint32_t>(lane);
            if (possible[lane] != 0)
                rays.testBlock(block, possible[lane], ray, BlockRay(rays.rayData(ray), packet.axes));
        }
    }
};

void closestHits(const WideTreeView& tree, const float* rays, HitData* hits, size_t count) {
    if (count < kMinStreamRays) return closestHitsSequential(tree, rays, hits, count);
    for (size_t begin = 0; begin < count; begin += kStreamSize) {
        const size_t end = count - begin < kStreamSize ? count : begin + kStreamSize;
        for (size_t i = begin; i < end; ++i) hits[i] = {rays[8 * i + 7], kNoPrimitive, 0.0f, 0.0f};
        Stream<false> stream(tree, rays + 8 * begin, hits + begin, nullptr);
        stream.traverse(static_cast<uint32_t>(end - begin));
        for (size_t i = begin; i < end; ++i)
            if (hits[i].primitive == kNoPrimitive) hits[i].t = kInfinity;
    }
}

void anyHits(const WideTreeView& tree, const float* rays, uint8_t* occluded, size_t count) {
    if (count < kMinStreamRays) return anyHitsSequential(tree, rays, occluded, count);
    for (size_t i = 0; i < count; ++i) occluded[i] = 0;
    for (size_t begin = 0; begin < count; begin += kStreamSize) {
        const size_t size = count - begin < kStreamSize ? count - begin : kStreamSize;
        Stream<true> stream(tree, rays + 8 * begin, nullptr, occluded + begin);
        stream.traverse(static_cast<uint32_t>(size));
    }
}

}  // namespace
}  // namespace rayscope::bvh::kernel
