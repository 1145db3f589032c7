#include "render/render_tile.h"

#include <array>
#include <cmath>
#include <utility>

#include "math/vectors.h"
#include "render/crash_report.h"
#include "trace/radiance_batch.h"

namespace rayscope::render {

namespace {
/// The thread works on samples as long as this lives.
struct Busy {
    CurrentSample& sample = CurrentSample::ofThisThread();
    Busy() = default;
    ~Busy() { sample.clear(); }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
};

/// The samples that a tile lacks, pixel by pixel.
class MissingSamples {
  public:
    MissingSamples(const PixelBounds& bounds, int have, int want)
        : bounds_(bounds), have_(have), want_(want), next_{bounds.x0, bounds.y0, have} {}

    /// The next ones, as many as there is room for; none at the end.
    std::span<const SampleId> take(std::span<SampleId> room) {
        std::size_t taken = 0;
        for (; taken < room.size() && next_.y < bounds_.y1; ++taken) {
            room[taken] = next_;
            if (++next_.index < want_) continue;
            next_.index = have_;
            if (++next_.x < bounds_.x1) continue;
            next_.x = bounds_.x0;
            ++next_.y;
        }
        return room.first(taken);
    }

  private:
    PixelBounds bounds_;
    int have_, want_;
    SampleId next_;
};
}  // namespace

bool renderTile(const trace::World& world, std::uint64_t seed, Film& film, int tile, int targetSamples,
                const std::stop_token& stop, RenderCounters& counters) {
    Film::TileCopy copy;
    film.read(tile, copy);
    if (copy.samples >= targetSamples) return true;
    const PixelBounds bounds = film.tileBounds(tile);
    std::uint64_t rays = 0, nonFinite = 0;
    Busy busy;
    MissingSamples missing(bounds, copy.samples, targetSamples);
    std::array<SampleId, trace::RadianceBatch::kSize> room;
    trace::RadianceBatch batch(world, seed);
    for (auto names = missing.take(room); !names.empty(); names = missing.take(room)) {
        batch.start(names);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (stop.stop_requested()) return false;
            busy.sample.set(names[i].x, names[i].y, names[i].index);
            batch.trace(i);
        }
        const std::span<const trace::SampleResult> results = batch.finish();
        for (std::size_t i = 0; i < names.size(); ++i) {
            const trace::SampleResult& sample = results[i];
            const int column = names[i].x - bounds.x0, row = names[i].y - bounds.y0;
            PixelSums& pixel = copy.pixels[static_cast<std::size_t>(row * (bounds.x1 - bounds.x0) + column)];
            pixel.radiance += sample.radiance;
            const double value = math::luminance(sample.radiance);
            pixel.squaredLuminance += value * value;
            rays += sample.rays;
            nonFinite += math::isFinite(sample.radiance) ? 0 : 1;
        }
    }
    copy.samples = targetSamples;
    film.commit(tile, std::move(copy));
    counters.rays += rays;
    counters.nonFiniteSamples += nonFinite;
    return true;
}

}  // namespace rayscope::render
