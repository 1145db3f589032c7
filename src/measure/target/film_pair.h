#pragma once
#include <rayscope/error_target.h>
#include <array>
#include <memory>
#include <vector>

#include "render/film.h"
#include "render/render_pass.h"

namespace rayscope::measure {

/// The numbers of samples that halves may have: the least of 4, 5, 6, 7, 8, 10, 12, 14, 16, 20 … that is no
/// less than x. With Sobol points the error goes down from one to the next but for little, and a forecast
/// that is wrong by one of them is wrong by no more than a quarter.
int roundUpSampleCount(double x);

/// A picture as two films with independent random numbers that grow alike.
class FilmPair {
  public:
    FilmPair(int width, int height, const PixelBounds& region);

    /// How many samples tiles get relative to the mean; all alike if it is not called.
    void share(std::vector<double> shares);

    /// Brings each half to `samples` per pixel on average. False if it was stopped, which leaves tiles in
    /// flight done. Runs on the threads of the calling arena.
    bool extend(const trace::World& world, std::uint64_t seed, int samples, const std::stop_token& stop,
                render::RenderCounters& counters);

    /// Samples per pixel of both together, mean of the region: now, and once extended to `samples`.
    double samplesTaken() const;
    double samplesAt(int samples) const;

    ErrorEstimate estimate(const ErrorTarget& target) const;
    /// Of all samples of both.
    RgbImage mean() const;

  private:
    VarianceImage varianceOfMean() const;
    int samplesOfTile(std::size_t tile, int samples) const;
    template <class SamplesOfTile>
    double perPixel(const SamplesOfTile& samplesOfTile) const;

    std::array<std::unique_ptr<render::Film>, 2> films_;
    std::vector<double> shares_;
};

}  // namespace rayscope::measure
