#include "measure/target/error_trend.h"

#include <algorithm>
#include <cmath>

namespace rayscope::measure {

namespace {

/// Weight of the usual slope: the sum of squared deviations of log samples of estimates that count as much, a
/// dozen estimates over four doublings.
constexpr double kPriorWeight = 8.0;
/// Estimates within three doublings of the latest are combined, with a margin for rounding.
const double kWindow = std::log(8.0) + 1e-9;

}  // namespace

ErrorTrend::ErrorTrend(ErrorMetric metric, SamplePattern sampler)
    : power_(metric == ErrorMetric::RelMse ? 2.0 : 1.0),
      priorSlope_(sampler == SamplePattern::Independent ? 0.5 : 0.8) {}

double ErrorTrend::rootOf(double value) const { return std::log(value) / power_; }

void ErrorTrend::add(double samples, const ErrorEstimate& estimate) {
    samples_ = samples;
    latest_ = estimate;
    if (estimate.error > 0.0)
        estimates_.push_back({std::log(samples), rootOf(estimate.error), rootOf(estimate.upper)});
}

double ErrorTrend::slope() const {
    double x = 0.0, y = 0.0;
    for (const LogEstimate& e : estimates_) {
        x += e.samples / static_cast<double>(estimates_.size());
        y += e.upper / static_cast<double>(estimates_.size());
    }
    double xx = kPriorWeight, xy = -kPriorWeight * priorSlope_;
    for (const LogEstimate& e : estimates_) {
        xx += (e.samples - x) * (e.samples - x);
        xy += (e.samples - x) * (e.upper - y);
    }
    return std::clamp(-xy / xx, 0.4, 1.1);
}

ErrorEstimate ErrorTrend::smoothed() const {
    ErrorEstimate result = latest_;
    if (!(latest_.error > 0.0)) return result;
    const double latest = std::log(samples_), fallRate = slope();
    double error = 0.0, upper = 0.0, count = 0.0;
    for (const LogEstimate& e : estimates_) {
        if (e.samples < latest - kWindow) continue;
        const double fallen = fallRate * (latest - e.samples);
        error += e.error - fallen;
        upper += e.upper - fallen;
        ++count;
    }
    result.error = std::exp(power_ * error / count);
    result.upper = std::exp(power_ * upper / count);
    return result;
}

double ErrorTrend::samplesFor(double error) const {
    const double upper = smoothed().upper;
    return upper > 0.0 ? samples_ * std::exp((rootOf(upper) - rootOf(error)) / slope()) : 0.0;
}

double ErrorTrend::errorAt(double samples) const {
    return smoothed().error * std::pow(samples / samples_, -power_ * slope());
}

}  // namespace rayscope::measure
