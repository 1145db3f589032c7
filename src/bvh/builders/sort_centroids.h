#pragma once
#include <span>
#include <stop_token>

#include "base/big_vector.h"
#include "bvh/bounds.h"

namespace rayscope::bvh {

/// The indices of refs in the order of their centroids along an axis; of equal centroids the smaller index
/// first. Throws Stopped soon after a request.
base::BigVector<std::uint32_t> orderByCentroid(std::span<const PrimitiveRef> refs, int axis,
                                               const std::stop_token& stop);

}  // namespace rayscope::bvh
