#include "cli/target_options.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "cli/command_line.h"

namespace rayscope::cli {

void TargetOptions::addTo(OptionList& list) {
    list.add("--target-error", &error,
             "Stop when the upper bound of the error is below this value; chooses the sample count "
             "automatically, with --spp as the limit")
        .positive();
    list.add("--confidence", &confidence, "Confidence level of --target-error")
        .range(0.5, 0.9999)
        .showDefault();
    list.add("--metric", &metric, "Metric of --target-error: rmse or relmse").showDefault();
    list.add("--worst-tile", &worstTile,
             "Apply --target-error to the worst tile of 32 x 32 pixels instead of the whole image");
    list.add("--adaptive", &adaptive,
             "With --target-error: take more samples where a pilot render finds more noise");
}

namespace {

void show(ProgressStyle style, const ErrorForecast& f, double target) {
    if (style == ProgressStyle::Json) {
        const nlohmann::json event = {{"samples", f.samples},
                                      {"elapsed_s", f.elapsedSeconds},
                                      {"error", f.estimate.error},
                                      {"error_upper", f.estimate.upper},
                                      {"target_error", target},
                                      {"expected_samples", f.samplesAtTarget},
                                      {"remaining_s", f.remainingSeconds},
                                      {"error_at_limit", f.errorAtLimit}};
        fmt::print(stderr, "{}\n", event.dump());
    }
    if (style != ProgressStyle::Bar) return;
    std::string line = fmt::format("{} samples  {}", f.samples, durationText(f.elapsedSeconds));
    if (f.estimate.upper > 0.0)
        line += fmt::format("  error {:.3g}, surely below {:.3g}, target {:.3g}  ETA {}", f.estimate.error,
                            f.estimate.upper, target, durationText(f.remainingSeconds));
    if (f.errorAtLimit > 0.0) line += fmt::format("  at the time limit {:.3g}", f.errorAtLimit);
    fmt::print(stderr, "\r\033[K{}", line);
    std::fflush(stderr);
}

}  // namespace

ErrorTargetResult renderToTarget(const RenderRequest& render, const TargetOptions& options, double timeLimit,
                                 int maxSamples, int threads, const InterruptGuard& interrupt,
                                 ProgressStyle style) {
    std::stop_source stop;
    const std::jthread watcher([&](const std::stop_token& ended) {
        while (!ended.stop_requested()) {
            if (interrupt.interrupted()) stop.request_stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
    ErrorTargetRequest request;
    request.render = render;
    request.target = {options.error, options.confidence, errorMetricNamed(options.metric), options.worstTile};
    request.adaptive = options.adaptive;
    request.timeLimit = timeLimit;
    if (maxSamples > 0) request.maxSamples = maxSamples;
    request.threads = threads;
    request.stop = stop.get_token();
    request.progress = [&](const ErrorForecast& forecast) { show(style, forecast, options.error); };
    ErrorTargetResult result = renderToTarget(request);
    if (style == ProgressStyle::Bar) fmt::print(stderr, "\r\033[K");
    return result;
}

}  // namespace rayscope::cli
