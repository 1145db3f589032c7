#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/error_target.h>
#include <algorithm>
#include <cmath>

#include "measure/statistics/deadline.h"
#include "measure/target/check_target.h"
#include "measure/target/error_trend.h"
#include "measure/target/half_films.h"
#include "measure/target/sample_allocation.h"
#include "render/check_request.h"
#include "render/pass_plan.h"
#include "render/probe_command.h"
#include "render/render_pass.h"
#include "render/thread_arena.h"
#include "sampling/hash.h"
#include "sampling/sample_stream.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

using Clock = std::chrono::steady_clock;

/// Samples per pixel and half at the first estimate, and at the first one that may end the rendering.
constexpr int kFirstEstimate = 4, kFirstStop = 8;
constexpr int kPilotSamples = 8;
/// With fewer pixels the upper bound is not accurate.
constexpr int kMinPixels = 256;
/// The rendering is planned to end where the expected upper bound is this fraction of the target, so that it
/// is usually below the target there.
constexpr double kPlannedFraction = 0.95;
/// The rendering continues if the bound of the latest estimate alone exceeds the target by this factor,
/// whatever the smoothed bound: a rare contribution may just have been sampled.
constexpr double kMaxLatestRatio = 1.5;

/// One rendering: both halves are extended to the same sample counts, with an estimate of the error at each.
class TargetRender {
  public:
    explicit TargetRender(const ErrorTargetRequest& request);
    ErrorTargetResult run();

  private:
    void compile();
    void renderSamples();
    void pilot();
    bool extendTo(int samples);
    void estimate(int samples);
    bool reached(int samples) const;
    void plan(int samples);
    int expectedEnd() const;
    double secondsPerSample() const;
    ErrorForecast forecast() const;
    void finish(StopReason reason);
    StopReason reasonOfStop() const {
        return request_.stop.stop_requested() ? StopReason::Interrupted : StopReason::TimeLimit;
    }
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const ErrorTargetRequest& request_;
    render::ThreadArena workers_;
    PixelBounds region_;
    std::unique_ptr<measure::HalfFilms> halves_;
    render::RenderCounters counters_;
    measure::ErrorTrend trend_;  ///< over samples per pixel and half
    int planned_ = 0;            ///< samples per half before which it does not end; 0: no plan yet
    Clock::time_point start_ = Clock::now();
    std::vector<std::pair<double, double>> timed_;  ///< samples taken and elapsed seconds
    std::unique_ptr<measure::Deadline> limit_;
    ErrorTargetResult result_;
};

TargetRender::TargetRender(const ErrorTargetRequest& request)
    : request_(request),
      workers_(request.threads),
      trend_(request.target.metric, request.render.settings.sampler) {
    const RenderRequest& render = request.render;
    region_ = render.region.value_or(PixelBounds{0, render.width, 0, render.height});
    const ErrorMetric metric = request.target.metric;
    if (metric != ErrorMetric::Rmse && metric != ErrorMetric::RelMse)
        throw InputError(
            fmt::format("--target-error supports only rmse and relmse, not '{}'", nameOf(metric)));
    const int pixels = (region_.x1 - region_.x0) * (region_.y1 - region_.y0);
    if (pixels < kMinPixels)
        throw InputError(fmt::format("--target-error needs at least {} pixels, not {}; use --spp instead",
                                     kMinPixels, pixels));
    render::setCrashContext(render::crashContextOf(render));
    limit_ =
        std::make_unique<measure::Deadline>(request.timeLimit > 0.0 ? request.timeLimit : 1e8, request.stop);
    if (sampling::dependsOnSampleCount(render.settings.sampler))
        throw InputError(
            "the jittered sampler needs a fixed number of samples; use sampler=sobol with --target-error");
    halves_ = std::make_unique<measure::HalfFilms>(render.width, render.height, region_);
}

ErrorTargetResult TargetRender::run() {
    try {
        compile();
        renderSamples();
    } catch (const Stopped&) {  // while compiling
        finish(reasonOfStop());
    }
    return std::move(result_);
}

void TargetRender::compile() {
    const RenderRequest& render = request_.render;
    const trace::CompileRequest compiled{render.scene, render.settings, render.camera, render.width,
                                         render.height};
    result_.world = workers_.run([&] { return trace::compile(compiled, nullptr, limit_->token()); });
}

void TargetRender::renderSamples() {
    if (request_.adaptive) pilot();
    timed_.emplace_back(0.0, elapsed());
    for (int samples = kFirstEstimate;; samples = measure::roundUpSampleCount(samples + 1)) {
        const int most = std::max(kFirstEstimate, request_.maxSamples / 2);
        samples = std::min(samples, most);
        if (!extendTo(samples)) {
            finish(reasonOfStop());
            break;
        }
        estimate(samples);
        if (reached(samples)) {
            finish(StopReason::Reached);
            break;
        }
        if (samples >= most) {
            finish(StopReason::SampleLimit);
            break;
        }
    }
}

/// Measures the noise of each tile with samples that are then discarded, so that the number of samples of a
/// pixel does not depend on their values and their mean is unbiased.
void TargetRender::pilot() {
    render::Film film(request_.render.width, request_.render.height, region_);
    const std::uint64_t seed = sampling::hashPair(request_.render.seed, 0x70696c6f74u);
    const bool complete = workers_.run([&] {
        return render::renderPass(*result_.world, seed, film, kPilotSamples, {limit_->token(), {}},
                                  counters_);
    });
    if (complete)
        halves_->setAllocation(measure::allocateSamples(film, request_.target.metric == ErrorMetric::RelMse,
                                                        request_.target.worstTile));
}

/// Extends both halves to `samples` per pixel on average. False if stopped.
bool TargetRender::extendTo(int samples) {
    for (int done = static_cast<int>(trend_.samples()); done < samples;) {
        done = render::nextPassTarget(done, samples, false);
        const bool complete = workers_.run([&] {
            return halves_->extend(*result_.world, request_.render.seed, done, limit_->token(), counters_);
        });
        if (!complete) return false;
        timed_.emplace_back(halves_->samplesTaken(), elapsed());
        if (request_.progress && done < samples) request_.progress(forecast());
    }
    return true;
}

void TargetRender::estimate(int samples) {
    trend_.add(samples, halves_->estimate(request_.target));
    if (!reached(samples)) plan(samples);
    result_.history.push_back(forecast());
    if (request_.progress) request_.progress(result_.history.back());
}

/// Whether the rendering ends at this estimate.
bool TargetRender::reached(int samples) const {
    const double target = request_.target.error;
    return samples >= std::max(kFirstStop, planned_) && trend_.latest().reliable &&
           trend_.smoothed().upper <= target && trend_.latest().upper <= kMaxLatestRatio * target;
}

/// In the second half of the samples the end is fixed in advance. To stop at the first estimate below the
/// target would select estimates that are low by chance, with bounds that are too low and wrong forecasts. If
/// the target is missed at the planned end, a new one is planned.
void TargetRender::plan(int samples) {
    if (samples < planned_) return;
    planned_ = 0;
    if (const int end = expectedEnd(); end <= 2.0 * samples) planned_ = end;
}

/// Expected samples per half at the target.
int TargetRender::expectedEnd() const {
    if (planned_ > trend_.samples()) return planned_;
    const double more =
        std::max(trend_.samples() + 1.0, trend_.samplesFor(kPlannedFraction * request_.target.error));
    return std::max(kFirstStop, measure::roundUpSampleCount(more));
}

/// From the later half of the samples, to leave out loading and compilation.
double TargetRender::secondsPerSample() const {
    const auto& [samples, seconds] = timed_.back();
    const auto half = std::find_if(timed_.rbegin(), timed_.rend(),
                                   [&](const auto& entry) { return entry.first <= 0.5 * samples; });
    return half == timed_.rend() || samples <= 0.0 ? 0.0 : (seconds - half->second) / (samples - half->first);
}

ErrorForecast TargetRender::forecast() const {
    const double taken = timed_.back().first;
    ErrorForecast f;
    f.samples = static_cast<int>(std::lround(taken));
    f.elapsedSeconds = elapsed();
    if (!trend_.hasEstimate()) return f;
    f.estimate = trend_.smoothed();
    const int samples = static_cast<int>(trend_.samples());
    f.samplesAtTarget = reached(samples) ? taken : std::max(taken, halves_->samplesAt(expectedEnd()));
    const double perSample = secondsPerSample();
    f.remainingSeconds = (f.samplesAtTarget - taken) * perSample;
    if (request_.timeLimit > 0.0 && f.estimate.error > 0.0 && perSample > 0.0) {
        const double more = std::max(0.0, request_.timeLimit - f.elapsedSeconds) / perSample;
        f.errorAtLimit = trend_.errorAt(trend_.samples() * (taken + more) / halves_->samplesAt(samples));
    }
    return f;
}

void TargetRender::finish(StopReason reason) {
    result_.reason = reason;
    result_.mean = halves_->mean();
    if (trend_.hasEstimate()) result_.estimate = trend_.smoothed();
    result_.seconds = elapsed();
    result_.rays = counters_.rays;
    result_.nonFiniteSamples = counters_.nonFiniteSamples;
    result_.samples = halves_->samplesTaken();

    const ErrorEstimate& e = result_.estimate;
    const std::string what = fmt::format("{}{}", nameOf(request_.target.metric),
                                         request_.target.worstTile ? " of the worst tile" : "");
    const std::string state =
        !trend_.hasEstimate()
            ? "before its error could be estimated"
            : fmt::format("at {} {:.3g}, {:.4g} % upper bound {:.3g}{}", what, e.error,
                          100.0 * request_.target.confidence, e.upper,
                          e.reliable ? "" : " (unreliable: few pixels hold most of the error)");
    constexpr const char* kReasons[] = {"target error reached", "stopped by the time limit",
                                        "stopped by the sample limit", "interrupted"};
    result_.text =
        fmt::format("{} {} with {:.0f} samples per pixel (target {:.3g})", kReasons[static_cast<int>(reason)],
                    state, result_.samples, request_.target.error);
}

}  // namespace

ErrorTargetResult renderToTarget(const ErrorTargetRequest& request) {
    render::checkRequest(request.render);
    measure::checkTarget(request.target);
    base::checkArgument(request.maxSamples >= 1, "maxSamples is {}; expected at least 1", request.maxSamples);
    base::checkArgument(request.timeLimit >= 0.0, "timeLimit is {}; expected at least 0", request.timeLimit);
    return TargetRender(request).run();
}

}  // namespace rayscope
