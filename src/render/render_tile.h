#pragma once
#include <rayscope/path.h>
#include <atomic>
#include <optional>
#include <stop_token>

#include "render/film.h"
#include "trace/world.h"

namespace rayscope::render {

/// What was counted while rendering; grows with each committed tile.
struct RenderCounters {
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> nonFiniteSamples{0};
};

/// Adds samples to each pixel of a tile until it has `targetSamples`, in the order of their index, and
/// commits the tile as a whole. If a stop is requested meanwhile, the tile stays as it was and the function
/// returns false. A stop is noticed between two samples.
bool renderTile(const trace::World& world, std::uint64_t seed, Film& film, int tile, int targetSamples,
                const std::stop_token& stop, RenderCounters& counters);

}  // namespace rayscope::render
