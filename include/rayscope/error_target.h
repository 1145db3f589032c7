#pragma once
// Rendering until the estimated error of the picture is below a limit, with a tested confidence level.
#include <rayscope/compare.h>
#include <rayscope/render_session.h>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace rayscope {

/// The largest error that a picture may have, and how that error is defined.
struct ErrorTarget {
    double error = 0.0;                      ///< in units of the metric
    double confidence = 0.95;                ///< level of the upper bound of the error, 0.5 … 0.9999
    ErrorMetric metric = ErrorMetric::Rmse;  ///< Rmse, or RelMse to weigh errors by brightness
    bool worstTile = false;                  ///< error of the worst 32 × 32 pixels, not of the whole image
};

/// The error of the mean of two independent halves of a picture, estimated from their difference.
struct ErrorEstimate {
    double error = 0.0;
    double upper = 0.0;  ///< upper bound of the error at the confidence level of the target
    /// False if few pixels hold most of the error: then rare bright samples may still be missing.
    bool reliable = true;
};
/// For each pixel the variance of its samples divided by their number. With stratified samples this is an
/// upper bound of the pixel's squared error, so only its distribution over the pixels is used.
using VarianceImage = Image<double>;
/// Estimates the error over the pixels of `region`; non-finite pixels are left out. Throws
/// std::invalid_argument if the images differ in size, the region is empty or outside, or the target is out
/// of range. The error itself comes from the halves alone. `variance` makes the upper bound more accurate,
/// and the test for errors that few pixels hold.
ErrorEstimate estimateError(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                            const ErrorTarget& target, const VarianceImage* variance = nullptr);

/// Progress of a rendering with an error target, and the expected samples, time and error.
struct ErrorForecast {
    int samples = 0;  ///< taken, per pixel on average, both halves together
    double elapsedSeconds = 0.0;
    ErrorEstimate estimate;         ///< from all estimates so far; error 0 before the first
    double samplesAtTarget = 0.0;   ///< expected samples per pixel; 0 before the first estimate
    double remainingSeconds = 0.0;  ///< expected until the target; 0 before the first estimate
    double errorAtLimit = 0.0;  ///< expected at the time limit; 0 without one or before the first estimate
};

enum class StopReason { Reached, TimeLimit, SampleLimit, Interrupted };

struct ErrorTargetRequest {
    RenderRequest render;  ///< its samples per pixel are ignored
    ErrorTarget target;
    bool adaptive = false;     ///< distribute samples over tiles by the noise of a pilot film
    double timeLimit = 0.0;    ///< seconds; 0: none
    int maxSamples = 1 << 20;  ///< per pixel, both halves together
    int threads = 0;           ///< 0: one per core
    std::function<void(const ErrorForecast&)> progress;
    std::stop_token stop;
};

struct ErrorTargetResult {
    RgbImage mean;                              ///< of both halves, linear
    std::shared_ptr<const trace::World> world;  ///< null if it was stopped before the scene was compiled
    StopReason reason = StopReason::Reached;
    std::string text;  ///< one sentence: why it stopped, and the error
    ErrorEstimate estimate;
    double samples = 0.0;  ///< per pixel, mean of the region
    double seconds = 0.0;
    std::uint64_t rays = 0, nonFiniteSamples = 0;
    std::vector<ErrorForecast> history;  ///< one forecast per estimate
};

/// Renders two halves of the picture with independent random numbers, estimates the error of their mean at
/// increasing sample counts, and stops as soon as its upper bound is below the target. Without a time limit
/// the result is a pure function of the request. Throws InputError if the metric is neither Rmse nor RelMse,
/// the region has fewer than 256 pixels, the sampler is jittered, or the scene cannot be traced.
ErrorTargetResult renderToTarget(const ErrorTargetRequest& request);

}  // namespace rayscope
