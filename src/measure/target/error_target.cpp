#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/error_target.h>
#include <algorithm>
#include <cmath>

#include "measure/statistics/workers.h"
#include "measure/target/error_trend.h"
#include "measure/target/film_pair.h"
#include "measure/target/sample_allocation.h"
#include "render/pass_plan.h"
#include "render/probe_command.h"
#include "render/render_pass.h"
#include "sampling/hash.h"
#include "sampling/sample_stream.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

using Clock = std::chrono::steady_clock;

/// Samples per pixel and half before the first look, and before a look may end the rendering.
constexpr int kFirstEstimate = 4, kFirstStop = 8;
constexpr int kPilotSamples = 8;
/// Fewer pixels say too little about their own spread.
constexpr int kMinPixels = 256;
/// The rendering is planned to end where the bound should be so far below the target that it mostly is.
constexpr double kPlannedFor = 0.95;
/// A rendering does not end at a look whose own bound is so many times above the target, whatever the looks
/// before it saw: something rare may just have been met.
constexpr double kLargestSurprise = 1.5;

/// The course of one rendering: both halves grow by the same plan, between looks at their difference.
class TargetRender {
  public:
    explicit TargetRender(const ErrorTargetRequest& request);
    ErrorTargetResult run();

  private:
    void pilot();
    bool extendTo(int samples);
    void look(int samples);
    bool reached(int samples) const;
    void plan(int samples);
    int expectedEnd() const;
    double secondsPerSample() const;
    ErrorForecast forecast() const;
    void finish(StopReason reason);
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const ErrorTargetRequest& request_;
    measure::Workers workers_;
    PixelBounds region_;
    std::unique_ptr<measure::FilmPair> halves_;
    render::RenderCounters counters_;
    measure::ErrorTrend trend_;  ///< over samples per pixel and half
    int planned_ = 0;            ///< samples per half before which it does not end; 0: no plan yet
    Clock::time_point start_ = Clock::now();
    std::vector<std::pair<double, double>> timed_;  ///< samples taken, seconds, as they grew
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
            fmt::format("the error '{}' cannot be promised: expected rmse or relmse", nameOf(metric)));
    const int pixels = (region_.x1 - region_.x0) * (region_.y1 - region_.y0);
    if (pixels < kMinPixels)
        throw InputError(fmt::format(
            "an error cannot be promised for {} pixels, only for {} or more; say --spp", pixels, kMinPixels));
    render::setCrashContext(render::crashContextOf(render));
    limit_ =
        std::make_unique<measure::Deadline>(request.timeLimit > 0.0 ? request.timeLimit : 1e8, request.stop);
    trace::CompileRequest compiled{render.scene, render.settings, render.camera, render.width, render.height};
    if (sampling::dependsOnSampleCount(compiled.settings.sampler))
        throw InputError(
            "the jittered sampler needs a fixed number of samples; use sampler=sobol with a target");
    result_.world = workers_.run([&] { return trace::compile(compiled, nullptr, request.stop); });
    halves_ = std::make_unique<measure::FilmPair>(render.width, render.height, region_);
}

ErrorTargetResult TargetRender::run() {
    if (request_.adaptive) pilot();
    timed_.emplace_back(0.0, elapsed());
    for (int samples = kFirstEstimate;; samples = measure::roundUpSampleCount(samples + 1)) {
        const int most = std::max(kFirstEstimate, request_.maxSamples / 2);
        samples = std::min(samples, most);
        if (!extendTo(samples)) {
            finish(request_.stop.stop_requested() ? StopReason::Interrupted : StopReason::TimeLimit);
            break;
        }
        look(samples);
        if (reached(samples)) {
            finish(StopReason::Reached);
            break;
        }
        if (samples >= most) {
            finish(StopReason::SampleLimit);
            break;
        }
    }
    return std::move(result_);
}

/// Finds out where the noise is, with samples that enter nothing else: so the number of samples of a pixel
/// does not depend on their values, and their mean stays without bias.
void TargetRender::pilot() {
    render::Film film(request_.render.width, request_.render.height, region_);
    const std::uint64_t seed = sampling::hashPair(request_.render.seed, 0x70696c6f74u);
    const bool complete = workers_.run([&] {
        return render::renderPass(*result_.world, seed, film, kPilotSamples, {limit_->token(), {}},
                                  counters_);
    });
    if (complete)
        halves_->share(measure::allocateSamples(film, request_.target.metric == ErrorMetric::RelMse,
                                                request_.target.worstTile));
}

/// Brings both halves to `samples` per pixel on average. False if it was stopped.
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

void TargetRender::look(int samples) {
    trend_.add(samples, halves_->estimate(request_.target));
    if (!reached(samples)) plan(samples);
    result_.history.push_back(forecast());
    if (request_.progress) request_.progress(result_.history.back());
}

/// Whether the rendering may end at this look.
bool TargetRender::reached(int samples) const {
    const double target = request_.target.error;
    return samples >= std::max(kFirstStop, planned_) && trend_.latest().trusted &&
           trend_.smoothed().upper <= target && trend_.latest().upper <= kLargestSurprise * target;
}

/// From half of the way on the end is fixed in advance: then it does not hang on which look happens to be
/// lucky, which would make bounds too small and forecasts wrong. If the target is missed there, a new end
/// follows.
void TargetRender::plan(int samples) {
    if (samples < planned_) return;
    planned_ = 0;
    if (const int end = expectedEnd(); end <= 2.0 * samples) planned_ = end;
}

/// Samples per half at which the target should be reached.
int TargetRender::expectedEnd() const {
    if (planned_ > trend_.samples()) return planned_;
    const double more =
        std::max(trend_.samples() + 1.0, trend_.samplesFor(kPlannedFor * request_.target.error));
    return std::max(kFirstStop, measure::roundUpSampleCount(more));
}

/// By the later half of the samples: what was loaded and compiled before them, and what else the machine did
/// then, says nothing about what is to come.
double TargetRender::secondsPerSample() const {
    const auto& [samples, seconds] = timed_.back();
    const auto half = std::find_if(timed_.rbegin(), timed_.rend(),
                                   [&](const auto& mark) { return mark.first <= 0.5 * samples; });
    return half == timed_.rend() || samples <= 0.0 ? 0.0 : (seconds - half->second) / (samples - half->first);
}

ErrorForecast TargetRender::forecast() const {
    const double taken = timed_.back().first;
    ErrorForecast f;
    f.samples = static_cast<int>(std::lround(taken));
    f.elapsedSeconds = elapsed();
    if (!trend_.any()) return f;
    f.estimate = trend_.smoothed();
    const int samples = static_cast<int>(trend_.samples());
    f.samplesAtTarget = reached(samples) ? taken : std::max(taken, halves_->samplesAt(expectedEnd()));
    const double pace = secondsPerSample();
    f.remainingSeconds = (f.samplesAtTarget - taken) * pace;
    if (request_.timeLimit > 0.0 && f.estimate.error > 0.0 && pace > 0.0) {
        const double more = std::max(0.0, request_.timeLimit - f.elapsedSeconds) / pace;
        f.errorAtLimit = trend_.errorAt(trend_.samples() * (taken + more) / halves_->samplesAt(samples));
    }
    return f;
}

void TargetRender::finish(StopReason reason) {
    result_.reason = reason;
    result_.mean = halves_->mean();
    if (trend_.any()) result_.estimate = trend_.smoothed();
    result_.seconds = elapsed();
    result_.rays = counters_.rays;
    result_.nonFiniteSamples = counters_.nonFiniteSamples;
    result_.samples = halves_->samplesTaken();

    const ErrorEstimate& e = result_.estimate;
    const std::string what = fmt::format("{}{}", nameOf(request_.target.metric),
                                         request_.target.worstTile ? " of the worst tile" : "");
    const std::string state =
        !trend_.any()
            ? "before its error could be estimated"
            : fmt::format("at {} {:.3g}, {:.2f} % sure to be below {:.3g}{}", what, e.error,
                          100.0 * request_.target.confidence, e.upper,
                          e.trusted ? "" : "; a few pixels hold most of the error, so this may be too low");
    constexpr const char* kWhy[] = {"the target is reached", "stopped by the time limit",
                                    "stopped by the limit of samples", "interrupted"};
    result_.words =
        fmt::format("{} {} with {:.0f} samples per pixel (target {:.3g})", kWhy[static_cast<int>(reason)],
                    state, result_.samples, request_.target.error);
}

}  // namespace

ErrorTargetResult renderToTarget(const ErrorTargetRequest& request) { return TargetRender(request).run(); }

}  // namespace rayscope
