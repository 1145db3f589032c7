#pragma once
#include "bvh/binary_tree.h"

namespace rayscope::measure {

/// The cost that TreeStatistics::sahCost predicts, counted: `lines` random lines through the root's box, all
/// directions and places being equally likely, visit every box that they meet. The mean number of inner nodes
/// and primitives in leaves per line. The prediction holds for boxes that lie inside their parents, so the
/// counted cost tends to it as 1/√lines.
double costOfRandomLines(const bvh::BinaryTree& tree, int lines);

}  // namespace rayscope::measure
