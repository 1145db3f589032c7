#pragma once
#include <rayscope/image.h>
#include <memory>
#include <optional>

#include "render/thread_arena.h"
#include "trace/compile.h"

namespace rayscope::measure {

/// A picture with its rendering time.
struct TimedRender {
    double seconds = 0.0;       ///< tracing and bloom
    double buildSeconds = 0.0;  ///< of BVHs that were not reused from the previous world
    std::uint64_t rays = 0;
    RgbImage image;  ///< linear, after bloom and before encoding
    std::shared_ptr<const trace::World> world;
};

/// Renders `request.settings.spp` samples per pixel, bit-identical to `rayscope render`. Empty if it takes
/// longer than `maxSeconds` or a stop is requested.
std::optional<TimedRender> renderTimed(render::ThreadArena& workers, const trace::CompileRequest& request,
                                       const trace::World* previous, std::uint64_t seed, double maxSeconds,
                                       const std::stop_token& stop);

}  // namespace rayscope::measure
