// clang-format off: the lanes come first
#include "bvh/kernel/lanes_avx2.inl"
// clang-format on
#include "bench/plain/plain_kernels.h"
#include "bvh/kernel/stream.inl"

const rayscope::bvh::kernel::Kernels rayscope::bench::kPlainKernels = {
    rayscope::bvh::kernel::closestHit, rayscope::bvh::kernel::anyHit, rayscope::bvh::kernel::closestHits,
    rayscope::bvh::kernel::anyHits};
