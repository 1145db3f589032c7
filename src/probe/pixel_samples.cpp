#include "probe/pixel_samples.h"

#include <rayscope/diagnostics.h>
#include <algorithm>
#include <cmath>

#include "math/vectors.h"
#include "render/film.h"
#include "trace/radiance.h"

namespace rayscope::probe {

namespace {

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

PixelSamples replayPixel(const trace::World& world, std::uint64_t seed, int x, int y, int count,
                         const std::function<void()>& beforeSample, const std::stop_token& stop) {
    PixelSamples samples;
    trace::NullObserver silent;
    for (int index = 0; index < count; ++index) {
        if (beforeSample) beforeSample();
        const SampleId name{x, y, index};
        const trace::SampleResult result = trace::radiance(world, seed, name, silent, stop);
        if (stop.stop_requested()) throw Stopped{};
        samples.values.push_back(result.radiance);
        samples.rays.push_back(static_cast<std::uint32_t>(result.rays));
        samples.positions.push_back(samplePosition(world, seed, name) - glm::dvec2(x, y));
    }
    return samples;
}

double SampleStatistics::errorOfMean() const {
    return luminance.empty() ? 0.0 : deviation / std::sqrt(static_cast<double>(luminance.size()));
}

SampleStatistics statisticsOf(const std::vector<RgbSum>& values) {
    SampleStatistics s;
    double squares = 0.0;
    // Welford's algorithm, without differences of large sums.
    for (const RgbSum& value : values) {
        const double x = math::luminance(value), before = s.mean;
        s.luminance.push_back(x);
        s.mean += (x - before) / static_cast<double>(s.luminance.size());
        squares += (x - before) * (x - s.mean);
        s.runningMean.push_back(s.mean);
    }
    if (values.size() < 2) return s;
    s.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
    const double median = medianOf(s.luminance);
    std::vector<double> distances;
    for (const double x : s.luminance) distances.push_back(std::abs(x - median));
    const double limit = 5.0 * medianOf(distances);
    for (std::size_t i = 0; i < distances.size(); ++i)
        if (distances[i] > limit && distances[i] > 1e-6 * std::abs(median)) s.outliers.push_back(i);
    return s;
}

}  // namespace rayscope::probe
