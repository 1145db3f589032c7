#include "render/render_pass.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include "render/tile_stop.h"

namespace rayscope::render {

bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, int targetSamples,
                const PassControl& control, RenderCounters& counters) {
    const std::vector<int> targets(static_cast<std::size_t>(film.tileCount()), targetSamples);
    return renderPass(world, seed, film, targets, control, counters);
}

bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, std::span<const int> targetSamples,
                const PassControl& control, RenderCounters& counters) {
    // Threads take tiles in order from one counter, for locality and an even load. The two counters also give
    // the thread sanitizer, which cannot see the synchronisation within TBB, the order of set-up, tasks and
    // return.
    std::atomic<int> next, completed;
    next.store(0);
    completed.store(0);
    const int tiles = film.tileCount();
    const TileStop tileStop(control.stop, control.drain);
    const std::stop_token stop = tileStop.token();
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<int>(0, tiles, 1),
        [&](const oneapi::tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i != range.end(); ++i) {
                const int tile = next.fetch_add(1);
                const bool isComplete =
                    !control.endsEarly() &&
                    renderTile(world, seed, film, tile, targetSamples[static_cast<std::size_t>(tile)], stop,
                               counters);
                completed.fetch_add(isComplete ? 1 : 0);
            }
        },
        oneapi::tbb::simple_partitioner{});
    return completed.load() == tiles;
}

}  // namespace rayscope::render
