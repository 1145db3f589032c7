#pragma once
// The queries of the wide tree, once per instruction set. All give the same hits, bit for bit.
#include "bvh/kernel/hit_acceptance.h"
#include "bvh/kernel/wide_layout.h"

namespace rayscope::bvh::kernel {

/// Receives the crossings of one ray, in any order.
struct CrossingSink {
    void (*add)(void* to, const HitData& crossing);
    void* to;
};

struct Kernels {
    /// Leaves `hit` as it is on a miss.
    bool (*closestHit)(const WideTreeView& tree, RayData ray, HitData& hit);
    bool (*anyHit)(const WideTreeView& tree, RayData ray);
    /// The same for many rays of eight floats each; a miss gives a default Hit.
    void (*closestHits)(const WideTreeView& tree, const float* rays, HitData* hits, size_t count);
    void (*anyHits)(const WideTreeView& tree, const float* rays, uint8_t* occluded, size_t count);
    /// All hits in (tMin, tMax], in any order.
    void (*crossings)(const WideTreeView& tree, RayData ray, CrossingSink sink);
};

extern const Kernels kPortableKernels, kSse2Kernels, kAvx2Kernels, kAvx512Kernels;

}  // namespace rayscope::bvh::kernel
