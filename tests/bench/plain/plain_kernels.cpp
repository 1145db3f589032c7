// clang-format off: the lanes come first
#include "bvh/kernel/lanes_avx2.inl"
// clang-format on
#include "bench/plain/plain_kernels.h"
#include "bvh/kernel/stream.inl"

const rayscope::kernel::Kernels rayscope::bench::kPlainKernels = {
    rayscope::kernel::closestHit, rayscope::kernel::anyHit, rayscope::kernel::closestHits,
    rayscope::kernel::anyHits};
