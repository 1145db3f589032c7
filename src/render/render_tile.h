#pragma once
#include <rayscope/path.h>
#include <atomic>
#include <stop_token>

#include "render/film.h"
#include "trace/world.h"

namespace rayscope::render {

/// Counts over all committed tiles.
struct RenderCounters {
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> nonFiniteSamples{0};  ///< which are part of the film
};

/// Adds samples to each pixel of a tile until it has `targetSamples`, in the order of their index, and
/// commits the tile as a whole. Returns false, and leaves the tile unchanged, if a stop is requested before;
/// this is checked within samples, too, so that it takes milliseconds.
bool renderTile(const trace::World& world, std::uint64_t seed, Film& film, int tile, int targetSamples,
                const std::stop_token& stop, RenderCounters& counters);

}  // namespace rayscope::render
