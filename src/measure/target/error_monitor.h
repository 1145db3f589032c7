#pragma once
// The error of a growing film, estimated from the film alone.
#include <rayscope/error_target.h>
#include <utility>
#include <vector>

#include "measure/target/error_trend.h"
#include "render/film.h"

namespace rayscope::measure {

/// Estimates the error of a film from the difference between its first and its second half of samples. For
/// independent samples the estimate of the squared error is unbiased. Later points of a Sobol sequence fill
/// the gaps between earlier ones; then the estimate is above the error, which is conservative.
class ErrorMonitor {
  public:
    explicit ErrorMonitor(ErrorTarget target = {}, SamplePattern sampler = SamplePattern::Sobol)
        : target_(target), trend_(target.metric, sampler) {}

    /// A copy of the sums of a film.
    struct Snapshot {
        int width = 0;
        std::vector<render::PixelSums> sums;  ///< row by row of the region
        std::vector<int> samples;             ///< of each pixel
        int completeSamples = 0;
    };
    static Snapshot snapshotOf(const render::Film& film);

    /// Whether a film with so many samples gives a new estimate: twice as many as at the last update().
    bool isEstimateDue(int completeSamples) const;
    /// Estimates the error from the last snapshot and this one.
    void update(Snapshot now);

    /// Whether there is an estimate.
    bool hasEstimate() const { return trend_.hasEstimate(); }
    const ErrorEstimate& latest() const { return trend_.latest(); }
    /// Whether the upper bound is below the target and the estimate is reliable.
    bool reached() const;

    /// The forecast for a film that has `samples` per pixel after `seconds`; `timeLimit` 0: none.
    ErrorForecast forecast(double samples, double seconds, double timeLimit) const;

  private:
    ErrorTarget target_;
    Snapshot before_;
    ErrorTrend trend_;  ///< over samples per pixel
};

}  // namespace rayscope::measure
