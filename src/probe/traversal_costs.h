#pragma once
// The traversal cost of binary trees for the rays of a picture.
#include <rayscope/accel.h>
#include <cstdint>
#include <vector>

#include "bvh/binary_tree.h"
#include "trace/world.h"

namespace rayscope::probe {

/// The rays of the first sample of some pixels, in the rest frame of a motion group.
struct ViewRays {
    std::vector<Ray> closest, any;
    std::size_t count() const { return closest.size() + any.size(); }
};

/// Of at most columns × rows pixels on a regular grid over the picture.
ViewRays raysOfView(const trace::World& world, std::uint64_t seed, std::size_t motionGroup, int columns,
                    int rows);

/// Per ray.
struct TraversalCosts {
    double nodes = 0.0;  ///< visited, leaves included
    double tests = 0.0;  ///< primitives tested
};
/// Of the binary tree itself, whatever layout production rays traverse.
TraversalCosts traversalCosts(const bvh::BinaryTree& tree, const AccelInput& input, const ViewRays& rays);

}  // namespace rayscope::probe
