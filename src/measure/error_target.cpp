#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/error_target.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "measure/error_slope.h"
#include "measure/tile_shares.h"
#include "measure/workers.h"
#include "render/crash_report.h"
#include "render/pass_plan.h"
#include "render/render_pass.h"
#include "sampling/hash.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

using Clock = std::chrono::steady_clock;

/// Samples per pixel and half before the first look, and before a look may end the rendering.
constexpr int kFirstLook = 4, kFirstStop = 8;
constexpr int kPilotSamples = 8;
/// Fewer pixels say too little about their own spread.
constexpr int kFewestPixels = 256;

/// The least of 1, 2, 3, 4, 6, 8, 12, 16 … that is no less than x: numbers at which Sobol points are
/// balanced. Between them more samples may well give a larger error.
int balancedCount(double x) {
    const double power = std::exp2(std::floor(std::log2(std::clamp(x, 1.0, 1e9))));
    return static_cast<int>(x <= power ? power : x <= 1.5 * power ? 1.5 * power : 2.0 * power);
}

/// The course of one rendering: both halves grow by the same plan, between looks at their difference.
class TargetRender {
  public:
    explicit TargetRender(const ErrorTargetRequest& request);
    ErrorTargetResult run();

  private:
    void pilot();
    bool extendTo(int samples);
    void look(int samples);
    int nextLook(int samples) const;
    double samplesNeeded(int samples) const;
    ErrorForecast forecast(int samples) const;
    void finish(StopReason reason);
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const ErrorTargetRequest& request_;
    Workers workers_;
    PixelBounds region_;
    std::array<std::unique_ptr<Film>, 2> halves_;
    std::vector<double> shares_;
    RenderCounters counters_;
    ErrorLooks looks_;  ///< samples per half, estimate
    Clock::time_point start_ = Clock::now();
    std::unique_ptr<Deadline> limit_;
    ErrorTargetResult result_;
};

TargetRender::TargetRender(const ErrorTargetRequest& request) : request_(request), workers_(request.threads) {
    const RenderRequest& render = request.render;
    region_ = render.region.value_or(PixelBounds{0, render.width, 0, render.height});
    const ErrorMetric metric = request.target.metric;
    if (metric != ErrorMetric::Rmse && metric != ErrorMetric::RelMse)
        throw InputError(
            fmt::format("the error '{}' cannot be promised: expected rmse or relmse", nameOf(metric)));
    const int pixels = (region_.x1 - region_.x0) * (region_.y1 - region_.y0);
    if (pixels < kFewestPixels)
        throw InputError(
            fmt::format("an error cannot be promised for {} pixels, only for {} or more; say --spp", pixels,
                        kFewestPixels));
    describeForCrashReport(render);
    limit_ = std::make_unique<Deadline>(request.timeLimit > 0.0 ? request.timeLimit : 1e8, request.stop);
    CompileRequest compiled{render.scene, render.settings, render.camera, render.width, render.height};
    // A jittered pattern must know how many samples follow, which nobody does here.
    if (compiled.settings.sampler == SamplePattern::Jittered)
        throw InputError(
            "the jittered sampler needs a fixed number of samples; use sampler=sobol with a target");
    result_.world = workers_.run([&] { return compile(compiled, nullptr, request.stop); });
    for (auto& half : halves_) half = std::make_unique<Film>(render.width, render.height, region_);
    shares_.assign(static_cast<std::size_t>(halves_[0]->tileCount()), 1.0);
}

ErrorTargetResult TargetRender::run() {
    if (request_.adaptive) pilot();
    for (int samples = kFirstLook;; samples = nextLook(samples)) {
        const int most = std::max(kFirstLook, request_.mostSamples / 2);
        samples = std::min(samples, most);
        if (!extendTo(samples)) {
            finish(request_.stop.stop_requested() ? StopReason::Interrupted : StopReason::TimeLimit);
            break;
        }
        look(samples);
        const ErrorEstimate& estimate = looks_.back().second;
        if (samples >= kFirstStop && estimate.trusted && estimate.upper <= request_.target.error) {
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
    Film film(halves_[0]->width(), halves_[0]->height(), region_);
    const std::uint64_t seed = hashPair(request_.render.seed, 0x70696c6f74u);
    const bool complete = workers_.run([&] {
        return renderPass(*result_.world, seed, film, kPilotSamples, {limit_->token(), {}}, counters_);
    });
    if (complete)
        shares_ = tileShares(film, request_.target.metric == ErrorMetric::RelMse, request_.target.worstTile);
}

/// Brings both halves to `samples` per pixel on average. False if it was stopped.
bool TargetRender::extendTo(int samples) {
    std::vector<int> targets(shares_.size());
    for (int done = looks_.empty() ? 0 : looks_.back().first; done < samples;) {
        done = nextPassTarget(done, samples, false);
        for (std::size_t tile = 0; tile < targets.size(); ++tile)
            targets[tile] = shares_[tile] == 1.0 ? done : std::max(2, balancedCount(shares_[tile] * done));
        for (std::size_t half = 0; half < halves_.size(); ++half) {
            const std::uint64_t seed =
                half == 0 ? request_.render.seed : hashPair(request_.render.seed, half);
            const bool complete = workers_.run([&] {
                return renderPass(*result_.world, seed, *halves_[half], targets, {{}, limit_->token()},
                                  counters_);
            });
            if (!complete) return false;
        }
        if (request_.progress && done < samples) request_.progress(forecast(done));
    }
    return true;
}

void TargetRender::look(int samples) {
    looks_.emplace_back(samples,
                        estimateError(halves_[0]->mean(), halves_[1]->mean(), region_, request_.target));
    result_.history.push_back(forecast(samples));
    if (request_.progress) request_.progress(result_.history.back());
}

/// Samples per half that the bound should need.
double TargetRender::samplesNeeded(int samples) const {
    const ErrorEstimate& last = looks_.back().second;
    double ratio = last.upper / request_.target.error;
    if (request_.target.metric == ErrorMetric::RelMse) ratio = std::sqrt(ratio);
    return std::max<double>(kFirstStop,
                            samples * std::pow(ratio, 1.0 / errorSlope(looks_, request_.target.metric)));
}

/// Twice as many samples, or fewer if fewer should do.
int TargetRender::nextLook(int samples) const {
    return std::max(balancedCount(samples + 1.0),
                    std::min(balancedCount(samplesNeeded(samples)), 2 * samples));
}

ErrorForecast TargetRender::forecast(int samples) const {
    ErrorForecast f;
    f.samples = 2 * samples;
    f.elapsedSeconds = elapsed();
    if (looks_.empty()) return f;
    f.estimate = looks_.back().second;
    const double perSample = f.elapsedSeconds / samples;
    const int needed = balancedCount(samplesNeeded(looks_.back().first));
    f.remainingSeconds = std::max(0, needed - samples) * perSample;
    if (request_.timeLimit > 0.0) {
        const double power = request_.target.metric == ErrorMetric::RelMse ? 2.0 : 1.0;
        const double atLimit = std::max(1.0, request_.timeLimit / perSample) / looks_.back().first;
        f.errorAtLimit =
            f.estimate.error * std::pow(atLimit, -power * errorSlope(looks_, request_.target.metric));
    }
    return f;
}

/// The mean of all samples of both halves; the halves have equal numbers of them, but for tiles that a limit
/// ended between the two.
RgbImage meanOfHalves(const Film& a, const Film& b) {
    RgbImage image = a.mean();
    const RgbImage other = b.mean();
    Film::TileCopy copyA, copyB;
    for (int tile = 0; tile < a.tileCount(); ++tile) {
        const double n = a.samples(tile), m = b.samples(tile);
        const PixelBounds bounds = a.tileBounds(tile);
        for (int y = bounds.y0; n + m > 0.0 && y < bounds.y1; ++y)
            for (int x = bounds.x0; x < bounds.x1; ++x)
                image.at(x, y) =
                    Rgb((n * glm::dvec3(image.at(x, y)) + m * glm::dvec3(other.at(x, y))) / (n + m));
    }
    return image;
}

void TargetRender::finish(StopReason reason) {
    result_.reason = reason;
    result_.mean = meanOfHalves(*halves_[0], *halves_[1]);
    if (!looks_.empty()) result_.estimate = looks_.back().second;
    result_.seconds = elapsed();
    result_.rays = counters_.rays;
    result_.nonFiniteSamples = counters_.nonFiniteSamples;
    double pixels = 0.0;
    for (int tile = 0; tile < halves_[0]->tileCount(); ++tile) {
        const PixelBounds b = halves_[0]->tileBounds(tile);
        const double area = static_cast<double>((b.x1 - b.x0) * (b.y1 - b.y0));
        pixels += area;
        result_.samples += area * (halves_[0]->samples(tile) + halves_[1]->samples(tile));
    }
    result_.samples /= pixels;

    const ErrorEstimate& e = result_.estimate;
    const std::string what = fmt::format("{}{}", nameOf(request_.target.metric),
                                         request_.target.worstTile ? " of the worst tile" : "");
    const std::string state =
        looks_.empty()
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
