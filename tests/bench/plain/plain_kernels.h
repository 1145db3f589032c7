#pragma once
#include "bvh/kernel/kernels.h"

namespace rayscope::bench {

/// The AVX2 kernels with a plain triangle test in their leaves.
extern const bvh::kernel::Kernels kPlainKernels;

}  // namespace rayscope::bench
