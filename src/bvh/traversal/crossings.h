#pragma once
// All hits of a ray, for the binary tree and without a tree; kernel/crossings.inl is for the wide one.
#include <rayscope/accel.h>
#include <bit>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/kernel/kernels.h"

namespace rayscope::bvh {

/// Passes all hits of the ray in (tMin, tMax] to `sink`, in any order. The ray need not be traceable.
void crossings(const BinaryTree& tree, const AccelInput& input, const Ray& ray, kernel::CrossingSink sink);

/// Tests every primitive. The same hits as Accel::crossings(), bit for bit.
std::vector<Hit> crossingsBruteForce(const AccelInput& input, const Ray& ray);

/// Appends every hit to `found`.
inline kernel::CrossingSink appendTo(std::vector<Hit>& found) {
    return {[](void* to, const kernel::HitData& hit) {
                static_cast<std::vector<Hit>*>(to)->push_back(std::bit_cast<Hit>(hit));
            },
            &found};
}

/// In order of t, and at equal t of the primitive numbers.
void sortCrossings(std::vector<Hit>& found);

}  // namespace rayscope::bvh
