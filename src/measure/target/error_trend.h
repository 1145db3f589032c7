#pragma once
#include <rayscope/error_target.h>
#include <utility>
#include <vector>

namespace rayscope::measure {

/// Trend of the error estimates of a picture over increasing samples. Single estimates are noisy, above all
/// for small pictures; smoothed() combines those of the last three doublings.
class ErrorTrend {
  public:
    /// `sampler` gives the slope that is assumed before there are enough estimates.
    ErrorTrend(ErrorMetric metric, SamplePattern sampler);

    /// Adds an estimate; `samples` must increase from call to call.
    void add(double samples, const ErrorEstimate& estimate);

    bool hasEstimate() const { return samples_ > 0.0; }
    /// The last estimate, and its samples; 0 before the first.
    const ErrorEstimate& latest() const { return latest_; }
    double samples() const { return samples_; }

    /// −d log √(squared error) / d log samples: least squares over all estimates with the usual slope of the
    /// sampler as a prior, which matters while they span few doublings; 0.4 … 1.1.
    double slope() const;

    /// The error at the latest samples: the geometric mean of the estimates from an eighth of them on, each
    /// extrapolated to the latest samples along the slope.
    ErrorEstimate smoothed() const;

    /// Expected samples at which the upper bound of smoothed() falls to `error`.
    double samplesFor(double error) const;
    /// Expected error of smoothed() at `samples`.
    double errorAt(double samples) const;

  private:
    /// Logarithms of the samples, and of the roots of the squared error and of its bound.
    struct LogEstimate {
        double samples, error, upper;
    };
    double rootOf(double value) const;

    double power_;  ///< the metric is the root of the squared error to this power
    double priorSlope_;
    double samples_ = 0.0;
    ErrorEstimate latest_;
    std::vector<LogEstimate> estimates_;  ///< without those of error 0
};

}  // namespace rayscope::measure
