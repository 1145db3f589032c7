// Without vector instructions streams are not faster than single rays.
// clang-format off: the lanes come first
#include "bvh/kernel/compress_portable.inl"
#include "bvh/kernel/lanes_portable.inl"
// clang-format on
#include "bvh/kernel/kernels.h"
#include "bvh/kernel/single_rays.inl"

const rayscope::bvh::kernel::Kernels rayscope::bvh::kernel::kPortableKernels = {
    closestHit, anyHit, closestHitsSequential, anyHitsSequential, crossings};
