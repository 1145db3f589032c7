#pragma once
// What trees cost the rays of a picture.
#include <rayscope/accel.h>
#include <cstdint>
#include <vector>

#include "bvh/binary_tree.h"
#include "trace/world.h"

namespace rayscope::probe {

/// The rays that the first sample of some pixels sends out, in the frame in which a motionGroup rests.
struct ViewRays {
    std::vector<Ray> closest, any;
    std::size_t count() const { return closest.size() + any.size(); }
};

/// Of at most columns × rows pixels, spread evenly over the picture.
ViewRays raysOfView(const trace::World& world, std::uint64_t seed, std::size_t motionGroup, int columns,
                    int rows);

/// Per ray.
struct TraversalCosts {
    double nodes = 0.0;  ///< boxes entered
    double tests = 0.0;  ///< primitives tested
};
TraversalCosts traversalCosts(const bvh::BinaryTree& tree, const AccelInput& input, const ViewRays& rays);

}  // namespace rayscope::probe
