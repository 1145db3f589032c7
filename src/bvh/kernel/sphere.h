#pragma once
#include "bvh/kernel/hit_acceptance.h"

namespace rayscope::bvh::kernel {

/// Tests one sphere {center, radius}; on success `found` has t. Compiled once for all instruction sets.
bool hitsSphere(RayData ray, const float* sphere, float bound, HitData& found);

}  // namespace rayscope::bvh::kernel
