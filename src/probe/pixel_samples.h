#pragma once
#include <rayscope/probe.h>
#include <functional>
#include <vector>

namespace rayscope::probe {

/// The first samples of a pixel, replayed.
struct PixelSamples {
    std::vector<RgbSum> values;
    std::vector<glm::dvec2> positions;  ///< within the pixel, 0 … 1, y downwards
    std::vector<std::uint32_t> rays;    ///< traced for each
};
/// `beforeSample`, if given, is called before each sample and may throw to stop. `stop` is checked within
/// samples, too, and throws Stopped.
PixelSamples replayPixel(const trace::World& world, std::uint64_t seed, int x, int y, int count,
                         const std::function<void()>& beforeSample = {}, const std::stop_token& stop = {});

/// Statistics of the luminance of samples.
struct SampleStatistics {
    std::vector<double> luminance, runningMean;
    double mean = 0.0, deviation = 0.0;  ///< standard deviation of a sample; 0 for fewer than two
    /// Samples farther from the median than 5 times the median absolute deviation, which outliers do not
    /// affect.
    std::vector<std::size_t> outliers;
    double errorOfMean() const;  ///< standard error, deviation / √n
};
SampleStatistics statisticsOf(const std::vector<RgbSum>& values);

}  // namespace rayscope::probe
