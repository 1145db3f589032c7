#pragma once
// Rendering until the picture is as accurate as asked for, with a confidence that was tested.
#include <rayscope/compare.h>
#include <rayscope/render_session.h>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace rayscope {

/// How accurate a picture is to be, and what it is to be judged by.
struct ErrorTarget {
    double error = 0.0;                      ///< in units of the metric
    double confidence = 0.95;                ///< that the picture is no worse; 0.5 … 0.9999
    ErrorMetric metric = ErrorMetric::Rmse;  ///< Rmse, or RelMse to weigh errors by brightness
    bool worstTile = false;  ///< the error of the worst 32 × 32 pixels rather than of the whole image
};

/// What two independent halves of a picture say of the error of their mean.
struct ErrorEstimate {
    double error = 0.0;
    double upper = 0.0;   ///< with the confidence asked for the error lies below
    bool trusted = true;  ///< false if a few pixels hold most of the error, so that others may be to come
};
/// Of each pixel, the variance of its samples divided by their number. It need not be the squared error,
/// which is smaller where samples are stratified: it says which pixels hold how much of it.
using VarianceImage = Image<double>;
/// Judges the pixels of `region`; what is not finite is left out. The error comes from the halves alone; with
/// `spread` the distance of the bound is known better, and so is whether a few pixels hold most of the error.
ErrorEstimate estimateError(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                            const ErrorTarget& target, const VarianceImage* spread = nullptr);

/// Where the rendering stands and what is to be expected.
struct ErrorForecast {
    int samples = 0;  ///< per pixel on average, of both halves together
    double elapsedSeconds = 0.0;
    ErrorEstimate estimate;         ///< by the looks so far; error 0 before the first
    double samplesAtTarget = 0.0;   ///< to be expected, per pixel; 0 before the first look
    double remainingSeconds = 0.0;  ///< to the target; 0 before the first look
    double errorAtLimit = 0.0;      ///< to be expected at the time limit; 0 without one, or not known yet
};

enum class StopReason { Reached, TimeLimit, SampleLimit, Interrupted };

struct ErrorTargetRequest {
    RenderRequest render;  ///< its samples per pixel are ignored
    ErrorTarget target;
    bool adaptive = false;     ///< more samples where a pilot, which is thrown away, found more noise
    double timeLimit = 0.0;    ///< seconds; 0: none
    int maxSamples = 1 << 20;  ///< per pixel, of both halves together
    int threads = 0;
    std::function<void(const ErrorForecast&)> progress;
    std::stop_token stop;
};

struct ErrorTargetResult {
    RgbImage mean;  ///< of both halves, linear
    std::shared_ptr<const trace::World> world;
    StopReason reason = StopReason::Reached;
    std::string words;  ///< why it stopped, as a sentence
    ErrorEstimate estimate;
    double samples = 0.0;  ///< per pixel, mean of the region
    double seconds = 0.0;
    std::uint64_t rays = 0, nonFiniteSamples = 0;
    std::vector<ErrorForecast> history;  ///< a forecast per look
};

/// Renders two halves of the picture with independent random numbers, looks at their difference now and then,
/// and stops as soon as the upper bound of the error of their mean is below the target. Without a time limit
/// the result is a pure function of the request. Throws InputError if the metric cannot be promised, the
/// region has fewer than 256 pixels, or the scene cannot be traced.
ErrorTargetResult renderToTarget(const ErrorTargetRequest& request);

}  // namespace rayscope
