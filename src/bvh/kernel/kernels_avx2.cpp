// clang-format off: the lanes come first
#include "bvh/kernel/lanes_avx2.inl"
// clang-format on
#include "bvh/kernel/kernels.h"
#include "bvh/kernel/stream.inl"

const rayscope::bvh::kernel::Kernels rayscope::bvh::kernel::kAvx2Kernels = {closestHit, anyHit, closestHits,
                                                                            anyHits, crossings};
