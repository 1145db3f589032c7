#pragma once
#include "bvh/kernel/query.h"

namespace rayscope::bvh::kernel {

/// Tests one sphere {center, radius}; on success `found` has t. Compiled once for all instruction sets.
bool hitsSphere(RayWords ray, const float* sphere, float bound, HitWords& found);

}  // namespace rayscope::bvh::kernel
