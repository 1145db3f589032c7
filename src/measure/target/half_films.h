#pragma once
#include <rayscope/error_target.h>
#include <array>
#include <memory>
#include <vector>

#include "render/film.h"
#include "render/render_pass.h"

namespace rayscope::measure {

/// The least of the sample counts 4, 5, 6, 7, 8, 10, 12, 14, 16, 20 … that is not below x. From each of them
/// to the next the error of Sobol points falls almost monotonically, and a forecast that is off by one count
/// is off by at most a quarter.
int roundUpSampleCount(double x);

/// A picture as two films with independent random numbers and equal sample counts.
class HalfFilms {
  public:
    HalfFilms(int width, int height, const PixelBounds& region);

    /// Sets the samples of each tile relative to the mean; without a call they are all 1.
    void setAllocation(std::vector<double> allocation);

    /// Extends each half to `samples` per pixel on average. False if stopped; tiles in flight are finished if
    /// they end within TileStop::kGrace.
    /// Runs in the calling task arena.
    bool extend(const trace::World& world, std::uint64_t seed, int samples, const std::stop_token& stop,
                render::RenderCounters& counters);

    /// Samples per pixel of both halves together, mean over the region: now, and after extend(`samples`).
    double samplesTaken() const;
    double samplesAt(int samples) const;

    ErrorEstimate estimate(const ErrorTarget& target) const;
    /// The mean of all samples of both halves.
    RgbImage mean() const;

  private:
    VarianceImage varianceOfMean() const;
    int samplesOfTile(std::size_t tile, int samples) const;
    template <class SamplesOfTile>
    double perPixel(const SamplesOfTile& samplesOfTile) const;

    std::array<std::unique_ptr<render::Film>, 2> films_;
    std::vector<double> allocation_;
};

}  // namespace rayscope::measure
