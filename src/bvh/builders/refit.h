#pragma once
#include <rayscope/accel.h>
#include <optional>

#include "bvh/binary_tree.h"
#include "bvh/layout/wide_tree.h"

namespace rayscope::bvh {

/// The same tree with new boxes for moved primitives. Nothing if a coordinate of a primitive of the tree is
/// NaN or infinite. `input` has as many triangles and spheres as that of the build, with valid indices.
std::optional<BinaryTree> refitted(const BinaryTree& tree, const AccelInput& input,
                                   const std::stop_token& stop);
std::optional<WideTree> refitted(const WideTree& tree, const AccelInput& input, const std::stop_token& stop);

/// The expected number of nodes, blocks and spheres that a random line through the box of a wide tree visits,
/// by their areas.
double sahCostOf(const WideTree& tree);

}  // namespace rayscope::bvh
