#include "measure/target/error_trend.h"

#include <algorithm>
#include <cmath>

namespace rayscope::measure {

namespace {

/// The usual slope counts as much as looks whose logarithms of samples have this sum of squared distances
/// from their mean: a dozen looks over four doublings.
constexpr double kPriorWeight = 8.0;
/// Looks within three doublings of the last, and those a rounding error below, are taken together.
const double kTogether = std::log(8.0) + 1e-9;

}  // namespace

ErrorTrend::ErrorTrend(ErrorMetric metric, SamplePattern sampler)
    : power_(metric == ErrorMetric::RelMse ? 2.0 : 1.0),
      priorSlope_(sampler == SamplePattern::Independent ? 0.5 : 0.8) {}

double ErrorTrend::rootOf(double value) const { return std::log(value) / power_; }

void ErrorTrend::add(double samples, const ErrorEstimate& look) {
    samples_ = samples;
    latest_ = look;
    if (look.error > 0.0) estimates_.push_back({std::log(samples), rootOf(look.error), rootOf(look.upper)});
}

double ErrorTrend::slope() const {
    double x = 0.0, y = 0.0;
    for (const LogEstimate& look : estimates_) {
        x += look.samples / static_cast<double>(estimates_.size());
        y += look.upper / static_cast<double>(estimates_.size());
    }
    double xx = kPriorWeight, xy = -kPriorWeight * priorSlope_;
    for (const LogEstimate& look : estimates_) {
        xx += (look.samples - x) * (look.samples - x);
        xy += (look.samples - x) * (look.upper - y);
    }
    return std::clamp(-xy / xx, 0.4, 1.1);
}

ErrorEstimate ErrorTrend::smoothed() const {
    ErrorEstimate result = latest_;
    if (!(latest_.error > 0.0)) return result;
    const double now = std::log(samples_), falls = slope();
    double error = 0.0, upper = 0.0, count = 0.0;
    for (const LogEstimate& look : estimates_) {
        if (look.samples < now - kTogether) continue;
        const double fallen = falls * (now - look.samples);
        error += look.error - fallen;
        upper += look.upper - fallen;
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
