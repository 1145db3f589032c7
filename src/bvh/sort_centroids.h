#pragma once
#include <span>
#include <stop_token>
#include <vector>

#include "bvh/bounds.h"

namespace rayscope {

/// The indices of refs in the order of their centroids along an axis; of equal centroids the smaller index
/// first. Throws Stopped soon after a request.
std::vector<std::uint32_t> orderByCentroid(std::span<const PrimitiveRef> refs, int axis,
                                           const std::stop_token& stop);

}  // namespace rayscope
