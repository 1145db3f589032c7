#pragma once
#include <rayscope/accel.h>
#include <optional>

#include "bvh/binary_tree.h"
#include "bvh/layout/wide_tree.h"

namespace rayscope::bvh {

/// The same tree around primitives that have moved: new boxes, bottom up. Nothing if a primitive of the tree
/// can no longer be hit, because a coordinate is NaN or infinite. `input` has as many triangles and spheres
/// as what the tree was built for, and no triangle without vertices.
std::optional<BinaryTree> refitted(const BinaryTree& tree, const AccelInput& input,
                                   const std::stop_token& stop);
std::optional<WideTree> refitted(const WideTree& tree, const AccelInput& input, const std::stop_token& stop);

/// What a random line that intersects the box of a wide tree is expected to open: nodes, blocks and spheres,
/// each as likely as its area says.
double sahCostOf(const WideTree& tree);

}  // namespace rayscope::bvh
