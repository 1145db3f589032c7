#include "cli/target_options.h"

#include <fmt/format.h>

#include "cli/command_line.h"

namespace rayscope::cli {

void TargetOptions::addTo(OptionList& list) {
    list.add("--target-error", &error,
             "Stop when the upper bound of the error is below this value; chooses the sample count "
             "automatically, with --spp as the limit")
        .above(0.0);
    list.add("--confidence", &confidence, "Confidence level of --target-error")
        .from(0.5, 0.9999)
        .showDefault();
    list.add("--metric", &metric, "Metric of --target-error: rmse or relmse")
        .suggest([] {
            return std::vector<std::string>{"rmse", "relmse"};
        })
        .showDefault();
    list.add("--worst-tile", &worstTile,
             "Apply --target-error to the worst tile of 32 x 32 pixels instead of the whole image");
    list.add("--adaptive", &adaptive,
             "With --target-error: take more samples where a pilot render finds more noise");
}

namespace {

void show(Progress& progress, const ErrorForecast& f, const TargetOptions& options) {
    std::string text = fmt::format("{} samples  {}", f.samples, durationText(f.elapsedSeconds));
    if (f.estimate.upper > 0.0)
        text += fmt::format("  error {:.3g}, {:g} % upper bound {:.3g}, target {:.3g}  {}", f.estimate.error,
                            100.0 * options.confidence, f.estimate.upper, options.error,
                            etaText(f.remainingSeconds));
    if (f.errorAtLimit > 0.0) text += fmt::format("  at the time limit {:.3g}", f.errorAtLimit);
    progress.show({{},
                   text,
                   {{"samples", static_cast<std::uint64_t>(f.samples)},
                    {"elapsed_s", f.elapsedSeconds},
                    {"error", f.estimate.error},
                    {"error_upper", f.estimate.upper},
                    {"target_error", options.error},
                    {"expected_samples", f.samplesAtTarget},
                    {"remaining_s", f.remainingSeconds},
                    {"error_at_limit", f.errorAtLimit}}});
}

}  // namespace

ErrorTargetResult renderToTarget(const RenderRequest& render, const TargetOptions& options,
                                 const TargetLimits& limits, ProgressStyle style) {
    Progress progress(style);
    ErrorTargetRequest request;
    request.render = render;
    request.target = {options.error, options.confidence, errorMetricNamed(options.metric), options.worstTile};
    request.adaptive = options.adaptive;
    request.timeLimit = limits.seconds;
    if (limits.samples > 0) request.maxSamples = limits.samples;
    request.threads = limits.threads;
    request.stop = limits.stop;
    request.progress = [&](const ErrorForecast& forecast) { show(progress, forecast, options); };
    return renderToTarget(request);
}

}  // namespace rayscope::cli
