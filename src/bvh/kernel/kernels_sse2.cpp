// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_sse2.inl"
// clang-format on
#include "bvh/kernel/kernels.h"
#include "bvh/kernel/stream.inl"

const rayscope::bvh::kernel::Kernels rayscope::bvh::kernel::kSse2Kernels = {closestHit, anyHit, closestHits,
                                                                            anyHits, crossings};
