#pragma once
#include "bvh/binary_tree.h"

namespace rayscope::measure {

/// The cost that TreeStatistics::sahCost predicts, measured: `lines` uniformly distributed random lines
/// through the root's box visit every node whose box they intersect. Returns the mean cost of inner nodes and
/// of primitives in leaves per line. For boxes inside their parents it converges to the prediction as
/// 1/√lines.
double costOfRandomLines(const bvh::BinaryTree& tree, int lines);

}  // namespace rayscope::measure
