#pragma once
#include <rayscope/path.h>
#include <cstdint>
#include <span>
#include <vector>

#include "base/big_vector.h"
#include "trace/world.h"

namespace rayscope::measure {

/// Rays with the times at which they are traced.
struct TimedRays {
    base::BigVector<Ray> rays;
    std::vector<float> times;  ///< empty if the world does not move
};

/// All rays of a picture, by kind of query. Within each block of samples camera rays come first, then the
/// others in the order of their paths, so that neighbours are as coherent as those that the picture traces
/// together.
struct PictureRays {
    TimedRays closest, any;
    std::size_t size() const { return closest.rays.size() + any.rays.size(); }
};

/// The rays that are traced for these samples.
PictureRays recordRays(const trace::World& world, std::uint64_t seed, std::span<const SampleId> samples);

}  // namespace rayscope::measure
