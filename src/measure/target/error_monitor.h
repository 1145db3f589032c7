#pragma once
// What a film that grows says about its own error, for whoever watches it.
#include <rayscope/error_target.h>
#include <utility>
#include <vector>

#include "measure/target/error_trend.h"
#include "render/film.h"

namespace rayscope::measure {

/// Compares a film with what it was at about half of its samples: two halves of the same pixels, one after
/// the other. For independent samples the estimate has the expectation of the squared error; later points of
/// a Sobol sequence fill the gaps of earlier ones, so there the estimate is above the error, on the safe
/// side.
class ErrorMonitor {
  public:
    explicit ErrorMonitor(ErrorTarget target = {}, SamplePattern sampler = SamplePattern::Sobol)
        : target_(target), trend_(target.metric, sampler) {}

    /// Sums of a film at one moment.
    struct Snapshot {
        int width = 0;
        std::vector<render::PixelSums> sums;  ///< row by row of the region
        std::vector<int> samples;             ///< of each pixel
        int completeSamples = 0;
    };
    static Snapshot take(const render::Film& film);

    /// Whether a film with so many samples is worth a look: twice as many as at the last one.
    bool isEstimateDue(int completeSamples) const;
    /// Takes a look.
    void look(Snapshot now);

    /// Looks that estimated an error.
    bool any() const { return trend_.any(); }
    const ErrorEstimate& latest() const { return trend_.latest(); }
    /// Whether the target is reached: the upper bound lies below it, and the estimate can be trusted.
    bool reached() const;

    /// What is to be expected of a film that has `samples` per pixel after `seconds`; `timeLimit` 0: none.
    ErrorForecast forecast(double samples, double seconds, double timeLimit) const;

  private:
    ErrorTarget target_;
    Snapshot before_;
    ErrorTrend trend_;  ///< over samples per pixel
};

}  // namespace rayscope::measure
