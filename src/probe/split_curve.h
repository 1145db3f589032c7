#pragma once
// The SAH cost of a node for every split plane.
#include <array>
#include <cstdint>
#include <vector>

#include <rayscope/accel.h>
#include "bvh/binary_tree.h"

namespace rayscope::probe {

/// SAH costs of the planes that a binned builder tries, for a line that intersects the box of the node, with
/// leaves as children (MacDonald, Booth 1990): kTraversalCost + kIntersectionCost · (area left · count left +
/// area right · count right) / area of the node.
struct SplitCurve {
    struct Plane {
        double position = 0.0;   ///< on the axis
        double cost = 0.0;       ///< NaN where one side is empty
        std::uint32_t left = 0;  ///< primitives
    };
    /// One for each border between bins; none along an axis on which all centroids are equal.
    std::array<std::vector<Plane>, 3> axes;
    double leafCost = 0.0;    ///< without a split
    double actualCost = 0.0;  ///< of the split in the tree; NaN for a leaf
    std::uint32_t primitives = 0;
};

/// Of the primitives below `node`, with `bins` ≥ 2 per axis.
SplitCurve splitCurve(const bvh::BinaryTree& tree, const AccelInput& input, std::uint32_t node, int bins);

}  // namespace rayscope::probe
