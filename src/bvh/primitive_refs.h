#pragma once
#include <rayscope/accel.h>
#include <vector>

#include "bvh/bounds.h"

namespace rayscope {

/// The boxes of all primitives with finite coordinates, in ascending order of their numbers.
struct PrimitiveRefs {
    std::vector<PrimitiveRef> refs;
    std::uint32_t dropped = 0;  ///< primitives with NaN or infinite coordinates
};

/// Throws std::invalid_argument with the number of the first triangle that names a vertex that does not
/// exist, and std::length_error if there are more primitives than a tree can number.
PrimitiveRefs collectPrimitiveRefs(const AccelInput& input, const std::stop_token& stop);

}  // namespace rayscope
