#include "render/render_pass.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

namespace rayscope {

bool renderPass(const World& world, std::uint64_t seed, Film& film, int targetSamples,
                const PassControl& control, RenderCounters& counters) {
    // Tiles are claimed in order from one counter: neighbours start together, and no thread is left with a
    // long tail.
    std::atomic<int> next{0};
    const int tiles = film.tileCount();
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<int>(0, tiles, 1),
        [&](const oneapi::tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i != range.end(); ++i) {
                if (control.endsEarly()) return;
                renderTile(world, seed, film, next.fetch_add(1), targetSamples, control.stop, counters);
            }
        },
        oneapi::tbb::simple_partitioner{});
    return !control.endsEarly();
}

}  // namespace rayscope
