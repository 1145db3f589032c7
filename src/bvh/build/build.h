#pragma once
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"

namespace rayscope::bvh {

/// Builds the tree with the chosen builder; what only the wide layout will be made of may be coarser than
/// what is kept to be looked at. See Accel::build for errors; besides them throws std::invalid_argument for
/// settings out of range.
BinaryTree buildBinaryTree(const AccelInput& input, const BuildSettings& settings);

}  // namespace rayscope::bvh
