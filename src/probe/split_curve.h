#pragma once
// What it would have cost to split a node elsewhere.
#include <array>
#include <cstdint>
#include <vector>

#include <rayscope/accel.h>
#include "bvh/binary_tree.h"

namespace rayscope::probe {

/// The surface area heuristic over the planes that a binned builder tries. Costs are those of a line that
/// meets the node's box, with leaves below (MacDonald, Booth 1990): kTraversalCost + kIntersectionCost ·
/// (area left · count left + area right · count right) / area of the node.
struct SplitCurve {
    struct Plane {
        double place = 0.0;  ///< along the axis, of centroids
        double cost = 0.0;   ///< NaN where one side would be empty
        std::uint32_t left = 0;
    };
    /// One for each border between bins; none along an axis on which all centroids agree.
    std::array<std::vector<Plane>, 3> axes;
    double leafCost = 0.0;  ///< without a split
    double made = 0.0;      ///< of the split that the tree has; NaN for a leaf
    std::uint32_t primitives = 0;
};

/// Of the primitives below `node`, with `bins` ≥ 2 per axis.
SplitCurve splitCurve(const bvh::BinaryTree& tree, const AccelInput& input, std::uint32_t node, int bins);

}  // namespace rayscope::probe
