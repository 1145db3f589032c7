#pragma once
#include <rayscope/render_session.h>
#include <stop_token>

namespace rayscope::probe {

/// What a sample of a pixel costs, as the mean over its first samples.
struct SampleCost {
    double nodes = 0.0;  ///< of the tree that production rays traverse, leaves included
    double tests = 0.0;  ///< triangles and spheres in the leaves among them
    double rays = 0.0;
    double microseconds = 0.0;  ///< as measured
    int nonFinite = 0;          ///< samples that are NaN or infinite; not a mean
};

/// Replays `samples` samples of a pixel; nodes and tests are 0 unless `countTraversals`, which replays them a
/// second time. After a stop request the result is meaningless.
SampleCost costAt(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                  bool countTraversals = true, const std::stop_token& stop = {});

}  // namespace rayscope::probe
