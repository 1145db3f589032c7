#include "render/render_tile.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "math/vectors.h"
#include "render/crash_report.h"
#include "trace/radiance_batch.h"

namespace rayscope::render {

namespace {

/// Clears the thread's current sample at the end of a tile.
struct CurrentSampleScope {
    CurrentSample& current = CurrentSample::ofThisThread();
    CurrentSampleScope() = default;
    ~CurrentSampleScope() { current.clear(); }
    CurrentSampleScope(const CurrentSampleScope&) = delete;
    CurrentSampleScope& operator=(const CurrentSampleScope&) = delete;
};

/// Iterates over the samples that a tile lacks, pixel by pixel.
class MissingSamples {
  public:
    MissingSamples(const PixelBounds& bounds, int first, int end)
        : bounds_(bounds), first_(first), end_(end), next_{bounds.x0, bounds.y0, first} {}

    /// The next samples, at most as many as fit into the buffer; none at the end.
    std::span<const SampleId> take(std::span<SampleId> buffer) {
        std::size_t taken = 0;
        for (; taken < buffer.size() && next_.y < bounds_.y1; ++taken) {
            buffer[taken] = next_;
            if (++next_.index < end_) continue;
            next_.index = first_;
            if (++next_.x < bounds_.x1) continue;
            next_.x = bounds_.x0;
            ++next_.y;
        }
        return buffer.first(taken);
    }

  private:
    PixelBounds bounds_;
    int first_, end_;  ///< sample indices
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
    CurrentSampleScope scope;
    MissingSamples missing(bounds, copy.samples, targetSamples);
    std::array<SampleId, trace::RadianceBatch::kSize> buffer;
    trace::RadianceBatch batch(world, seed, stop);
    const std::span<SampleId> taken = std::span(buffer).first(batch.size());
    for (auto samples = missing.take(taken); !samples.empty(); samples = missing.take(taken)) {
        batch.start(samples);
        while (const std::optional<std::size_t> sample = batch.next()) {
            if (stop.stop_requested()) return false;
            scope.current.set(samples[*sample]);
            batch.trace();
        }
        const std::span<const trace::SampleResult> results = batch.finish();
        // During the last samples or their shadow rays: the results are meaningless.
        if (stop.stop_requested()) return false;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const trace::SampleResult& sample = results[i];
            const int column = samples[i].x - bounds.x0, row = samples[i].y - bounds.y0;
            PixelSums& pixel = copy.pixels[static_cast<std::size_t>(row * (bounds.x1 - bounds.x0) + column)];
            // A non-finite sample is added like any other: the pixel becomes NaN or infinite and is reported.
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
