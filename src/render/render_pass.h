#pragma once
#include <span>
#include <stop_token>

#include "render/film.h"
#include "render/render_tile.h"
#include "trace/world.h"

namespace rayscope::render {

/// Early end of a pass: `stop` drops the tiles in flight, `drain` starts no others and completes those that
/// end within TileStop::kGrace.
struct PassControl {
    std::stop_token stop;
    std::stop_token drain;
    bool endsEarly() const { return stop.stop_requested() || drain.stop_requested(); }
};

/// Renders every tile of the film up to `targetSamples` on the threads of the calling arena. Returns false if
/// tiles were left out or dropped because of a stop; the film is valid in either case, and a later pass
/// continues it.
bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, int targetSamples,
                const PassControl& control, RenderCounters& counters);

/// The same with a number of samples for each tile.
bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, std::span<const int> targetSamples,
                const PassControl& control, RenderCounters& counters);

}  // namespace rayscope::render
