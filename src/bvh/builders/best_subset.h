#pragma once
#include <bit>
#include <limits>
#include <span>

#include "bvh/bounds.h"
#include "bvh/layout/primitive_refs.h"

namespace rayscope::bvh {

/// Up to this many primitives are split by exhaustive search, which finds better splits than bins in less
/// time.
constexpr std::size_t kMaxExhaustiveSplit = 4;

struct Subset {
    float cost = std::numeric_limits<float>::infinity();
    unsigned left = 0;  ///< bit i: primitive i belongs to the left side
};

/// The cheapest split of 2 … kMaxExhaustiveSplit primitives by the surface area heuristic; areas are scaled
/// before they are compared.
inline Subset bestSubset(std::span<const PrimitiveRef> refs, float scale) {
    Bounds4 box[1 << kMaxExhaustiveSplit];
    float cost[1 << kMaxExhaustiveSplit];
    const unsigned all = (1u << refs.size()) - 1;
    for (unsigned set = 1; set < all; ++set) {
        box[set] = box[set & (set - 1)];
        box[set].extend(refs[static_cast<std::size_t>(std::countr_zero(set))].bounds());
        cost[set] = box[set].halfArea(scale) * static_cast<float>(std::popcount(set));
    }
    Subset best;
    for (unsigned left = 1; left < all; left += 2) {
        const float sum = cost[left] + cost[all ^ left];
        // Among equal costs halves keep the tree shallow.
        const bool isHalf = 2 * static_cast<std::size_t>(std::popcount(left)) == refs.size();
        if (sum < best.cost || (sum == best.cost && isHalf)) best = {sum, left};
    }
    return best;
}

}  // namespace rayscope::bvh
