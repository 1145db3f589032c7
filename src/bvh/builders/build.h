#pragma once
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"

namespace rayscope::bvh {

/// Builds the tree with the chosen builder. Leaves may be larger if the tree is only collapsed and not kept.
/// Throws like Accel::build.
BinaryTree buildBinaryTree(const AccelInput& input, const BuildSettings& settings);

}  // namespace rayscope::bvh
