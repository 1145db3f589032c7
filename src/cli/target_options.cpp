#include "cli/target_options.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <thread>

namespace rayscope::cli {

void TargetOptions::addTo(CLI::App& command) {
    command
        .add_option("--target-error", error,
                    "Stop when the image is this accurate; samples per pixel are no longer given but found")
        ->check(CLI::PositiveNumber);
    command.add_option("--confidence", confidence, "How sure to be of --target-error")
        ->check(CLI::Range(0.5, 0.9999))
        ->capture_default_str();
    command.add_option("--metric", metric, "What --target-error is about: rmse or relmse")
        ->capture_default_str();
    command.add_flag("--worst-tile", worstTile,
                     "Hold --target-error in each 32 x 32 pixels, not for the whole image");
    command.add_flag("--adaptive", adaptive,
                     "With --target-error: take more samples where a pilot finds more noise");
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
