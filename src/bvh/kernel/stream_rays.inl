// The rays of a stream. Include after one of the lanes_*.inl.
#include "bvh/kernel/packet.inl"

namespace rayscope::bvh::kernel {
namespace {

constexpr uint32_t kStreamSize = 1024;

template <bool kAny>
struct StreamRays {
    const WideTreeView& tree;
    const float* allRayData;                ///< eight of each ray
    HitData* best;                          ///< of closest-hit queries, one per ray
    uint8_t* occluded;                      ///< of any-hit queries, one per ray
    alignas(64) float bounds[kStreamSize];  ///< scaled best.t; negative: occluded
    PackedRay prepared[kStreamSize];
    FastShear shears[kStreamSize];
    bool hasShear[kStreamSize];  ///< whether shears[ray] is set

    RAYSCOPE_INLINE StreamRays(const WideTreeView& t, const float* data, HitData* b, uint8_t* o)
        : tree(t), allRayData(data), best(b), occluded(o) {}
    RAYSCOPE_INLINE RayData rayData(uint32_t ray) const { return allRayData + size_t{8} * ray; }

    /// Prepares up to sixteen rays. Returns a bit for each that is traceable and in the range of FastRay; the
    /// others are left to queryOne().
    RAYSCOPE_INLINE unsigned prepare(uint32_t first, uint32_t size, Packet& packet) {
        const float* from = rayData(first);
        float padded[8 * kPacketSize] = {};  // zeros are not traceable
        if (size < kPacketSize) {
            __builtin_memcpy(padded, from, 8 * size * sizeof(float));
            from = padded;
        }
        unsigned usable = 0;
        for (uint32_t group = 0; group < kPacketGroups; ++group) {
            const uint32_t offset = kWidth * group;
            usable |= prepareEight(from + 8 * offset, tree.maxCoordinate, prepared + first + offset,
                                   bounds + first + offset, packet.columns[group])
                      << offset;
        }
        __builtin_memset(hasShear + first, 0, kPacketSize);
        return usable;
    }
    RAYSCOPE_INLINE void queryOne(uint32_t ray) {
        if constexpr (kAny) {
            occluded[ray] = anyHit(tree, rayData(ray));
        } else {
            closestHit(tree, rayData(ray), best[ray]);
        }
    }

    RAYSCOPE_INLINE void occlude(uint32_t ray) {
        occluded[ray] = 1;
        bounds[ray] = -1.0f;
    }
    /// Stores a result.
    RAYSCOPE_INLINE void keep(uint32_t ray, const QueryState& state) {
        if constexpr (kAny) {
            occlude(ray);
        } else {
            best[ray] = state.best;
            bounds[ray] = state.bound;
        }
    }
    RAYSCOPE_INLINE bool isDone(uint32_t ray) const { return kAny && bounds[ray] < 0.0f; }
    RAYSCOPE_INLINE QueryState stateOf(uint32_t ray) const {
        const PackedRay& fast = prepared[ray];
        const HitData none{rayData(ray)[7], kNoPrimitive, 0.0f, 0.0f};
        return {rayData(ray), fast.scale, fast.tMin, bounds[ray], kAny ? none : best[ray]};
    }

    RAYSCOPE_INLINE FastShear& shearOf(uint32_t ray) {
        if (!hasShear[ray]) shears[ray].isReady = false;
        hasShear[ray] = true;
        return shears[ray];
    }

    RAYSCOPE_INLINE void visitSphere(const SphereRecord& sphere, uint32_t ray) {
        QueryState state = stateOf(ray);
        if (testSphere(sphere, state)) keep(ray, state);
    }
    /// Like visitLeaf() for one ray, but loads the state only if a hit is possible, which saves 5 % of the
    /// time on long thin triangles.
    RAYSCOPE_INLINE void visitBlock(const TriangleBlock& block, ChildRef leaf, uint32_t ray) {
        FastShear& shear = shearOf(ray);
        shear.prepareOnce(rayData(ray), prepared[ray].scale);
        const FilterResult found = filterTriangles(block, leaf, shear, prepared[ray].tMin, bounds[ray]);
        if (found.possible == 0) return;
        if (kAny && found.certain() != 0) return occlude(ray);
        testBlock(block, found.possible, ray, BlockRay(rayData(ray), shear));
    }
    RAYSCOPE_INLINE void testBlock(const TriangleBlock& block, unsigned possible, uint32_t ray,
                                   const BlockRay& exact) {
        QueryState state = stateOf(ray);
        if (testTriangles<kAny>(block, possible, exact, state)) keep(ray, state);
    }

    [[gnu::noinline]] void visitLeaf(ChildRef leaf, const uint32_t* list, uint32_t count) {
        if (leaf < kSphereTag) {
            const TriangleBlock& block = tree.blocks[leaf & kBlockIndexMask];
            for (uint32_t i = 0; i < count; ++i)
                if (!isDone(list[i])) visitBlock(block, leaf, list[i]);
        } else {
            const SphereRecord& sphere = tree.spheres[leaf & kSphereIndexMask];
            for (uint32_t i = 0; i < count; ++i)
                if (!isDone(list[i])) visitSphere(sphere, list[i]);
        }
    }

    /// Traverses a subtree with each ray of a list.
    RAYSCOPE_INLINE void traverseSingleRays(ChildRef ref, const uint32_t* list, uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t ray = list[i];
            if (isDone(ray)) continue;
            QueryState state = stateOf(ray);
            const FastBoxLanes lanes(state.ray, prepared[ray].unpacked());
            if constexpr (kAny) {
                if (traverseAny(tree, ref, lanes, shearOf(ray), state)) keep(ray, state);
            } else {
                traverseClosest(tree, ref, lanes, shearOf(ray), state);
                keep(ray, state);
            }
        }
    }
};

}  // namespace
}  // namespace rayscope::bvh::kernel
