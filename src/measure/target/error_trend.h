#pragma once
#include <rayscope/error_target.h>
#include <utility>
#include <vector>

namespace rayscope::measure {

/// How the estimated error of a picture falls while samples are added. One look is noisy, above all at a
/// small picture; what the looks of the last three doublings say together is less so.
class ErrorTrend {
  public:
    /// `sampler` says how fast errors fall before the looks can.
    ErrorTrend(ErrorMetric metric, SamplePattern sampler);

    /// Takes note of an estimate at `samples`, which grow from look to look.
    void add(double samples, const ErrorEstimate& look);

    bool any() const { return samples_ > 0.0; }
    /// The last look, and its samples; 0 before the first.
    const ErrorEstimate& latest() const { return latest_; }
    double samples() const { return samples_; }

    /// −d log √(squared error) / d log samples: least squares over all looks, drawn towards what is usual for
    /// the sampler as long as they span few doublings; 0.4 … 1.1.
    double slope() const;

    /// The error at the last look, by all looks at no less than an eighth of its samples: the geometric mean
    /// of their estimates, each moved to the last look along the slope.
    ErrorEstimate smoothed() const;

    /// The samples at which the upper bound of smoothed() should be down to `error`.
    double samplesFor(double error) const;
    /// The error of smoothed() to be expected at `samples`.
    double errorAt(double samples) const;

  private:
    /// Logarithms of samples, and of the roots of the squared error and of its bound.
    struct LogEstimate {
        double samples, error, upper;
    };
    double rootOf(double value) const;

    double power_;  ///< of the root of the squared error that is the metric
    double priorSlope_;
    double samples_ = 0.0;
    ErrorEstimate latest_;
    std::vector<LogEstimate> estimates_;  ///< those that saw an error
};

}  // namespace rayscope::measure
