#pragma once
#include <rayscope/image.h>
#include <memory>
#include <optional>

#include "measure/statistics/workers.h"
#include "trace/compile.h"

namespace rayscope::measure {

/// One timed picture.
struct Trial {
    double seconds = 0.0;       ///< tracing and bloom
    double buildSeconds = 0.0;  ///< of hierarchies that the previous world could not lend
    std::uint64_t rays = 0;
    RgbImage image;  ///< developed, linear
    std::shared_ptr<const trace::World> world;
};

/// Renders `request.settings.spp` samples per pixel as `rayscope render` would. Nothing is returned if it
/// takes longer than `maxSeconds` or a stop is requested.
std::optional<Trial> runTrial(Workers& workers, const trace::CompileRequest& request,
                              const trace::World* previous, std::uint64_t seed, double maxSeconds,
                              const std::stop_token& stop);

}  // namespace rayscope::measure
