#include "render/render_tile.h"

#include <cmath>

#include "render/crash_report.h"
#include "trace/radiance.h"

namespace rayscope {

namespace {
bool isFinite(const RgbSum& c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

/// The thread works on samples as long as this lives.
struct Busy {
    BusySample& sample = BusySample::ofThisThread();
    Busy() = default;
    ~Busy() { sample.clear(); }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
};
}  // namespace

bool renderTile(const World& world, std::uint64_t seed, Film& film, int tile, int targetSamples,
                const std::stop_token& stop, RenderCounters& counters) {
    Film::TileCopy copy;
    film.read(tile, copy);
    if (copy.samples >= targetSamples) return true;
    const PixelBounds bounds = film.tileBounds(tile);
    std::uint64_t rays = 0, nonFinite = 0;
    NullObserver silent;
    Busy busy;
    PixelSums* pixel = copy.pixels.data();
    for (int y = bounds.y0; y < bounds.y1; ++y) {
        for (int x = bounds.x0; x < bounds.x1; ++x, ++pixel) {
            for (int index = copy.samples; index < targetSamples; ++index) {
                if (stop.stop_requested()) return false;
                busy.sample.set(x, y, index);
                const SampleResult sample = radiance(world, seed, {x, y, index}, silent);
                pixel->radiance += sample.radiance;
                const double value = luminance(sample.radiance);
                pixel->squaredLuminance += value * value;
                rays += sample.rays;
                nonFinite += isFinite(sample.radiance) ? 0 : 1;
            }
        }
    }
    copy.samples = targetSamples;
    film.commit(tile, copy);
    counters.rays += rays;
    counters.nonFiniteSamples += nonFinite;
    return true;
}

}  // namespace rayscope
