#include "render/render_pass.h"

#include "render/ordered_tasks.h"
#include "render/tile_stop.h"

namespace rayscope::render {

bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, int targetSamples,
                const PassControl& control, RenderCounters& counters) {
    const std::vector<int> targets(static_cast<std::size_t>(film.tileCount()), targetSamples);
    return renderPass(world, seed, film, targets, control, counters);
}

bool renderPass(const trace::World& world, std::uint64_t seed, Film& film, std::span<const int> targetSamples,
                const PassControl& control, RenderCounters& counters) {
    const TileStop tileStop(control.stop, control.drain);
    const std::stop_token stop = tileStop.token();
    std::atomic<int> completed{0};
    runOrderedTasks(film.tileCount(), [&](int tile) {
        if (!control.endsEarly() && renderTile(world, seed, film, tile,
                                               targetSamples[static_cast<std::size_t>(tile)], stop, counters))
            ++completed;
    });
    return completed == film.tileCount();
}

}  // namespace rayscope::render
