#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/trade.h>
#include <filesystem>

#include "base/atomic_file.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt_stop_source.h"
#include "cli/progress.h"
#include "cli/scene_options.h"

namespace rayscope::cli {

namespace {

struct TradeOptions {
    SceneOptions scene;
    std::string folder, progress;
    double budget = 60.0;
    bool noCache = false, quiet = false, json = false;
};

void showProgress(Progress& progress, const TradeProgress& p) {
    progress.show({p.fraction,
                   p.phase + "  " + etaText(p.remainingSeconds),
                   {{"phase", p.phase}, {"progress", p.fraction}, {"remaining_s", p.remainingSeconds}}});
}

void printSummary(const TradeResult& r, const std::string& scene) {
    fmt::print("{} at {} x {}, {} threads: {} candidates, {} blocks, {:.1f} s\n", scene, r.width, r.height,
               r.threads,
               std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return p.runs > 0; }),
               r.blocks, r.spentSeconds);
    fmt::print("reference: 2 x {} samples, RMSE {:.3g}{}\n", r.reference.samples, r.reference.error,
               r.reference.fromCache ? " (continued from the cache)" : "");
    if (r.complete) {
        fmt::print("timing noise of the machine: {:.1f} %\n", 100.0 * r.smallestTimeDifference);
        fmt::print("\nrecommended settings, with 95 % prediction intervals of one more run:\n");
    }
    for (const TradeAdvice& advice : r.advice) {
        const TradePoint& p = r.points[advice.point];
        fmt::print(
            "  {:.3g} s [{:.3g}, {:.3g}]  RMSE {:.3g} [{:.3g}, {:.3g}]\n    rayscope render {} {} -o OUT\n",
            p.predictedSeconds.value, p.predictedSeconds.lower, p.predictedSeconds.upper,
            p.predictedError.value, p.predictedError.lower, p.predictedError.upper, scene,
            renderArguments(r, p));
    }
    for (const TradePreset& preset : r.presetPoints)
        fmt::print("preset {}: {:.3g} s, RMSE {:.3g}, excess time over the Pareto front {}\n", preset.preset,
                   r.points[preset.point].seconds.value, r.points[preset.point].error.value,
                   excessText(r, preset));
    for (const std::string& remark : r.remarks) fmt::print("note: {}\n", remark);
}

void writeReports(const TradeResult& result, const std::string& folder) {
    const std::filesystem::path path(folder);
    base::writeFileAtomically((path / "trade.json").string(), tradeJson(result));
    base::writeFileAtomically((path / "trade.csv").string(), tradeCsv(result));
    base::writeFileAtomically((path / "trade.html").string(), tradeHtml(result));
}

int runTrade(const TradeOptions& options) {
    if (!options.folder.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.folder, error);
        base::checkFileDestination((std::filesystem::path(options.folder) / "trade.json").string());
    }
    const InterruptStopSource interrupt;
    TradeRequest request;
    request.render = openScene(options.scene, options.quiet, progressStyle(options.progress, options.quiet));
    request.budgetSeconds = options.budget;
    request.threads = options.scene.threads;
    request.stop = interrupt.token();
    if (!options.noCache) request.cacheFolder = referenceCacheFolder();
    Progress progress(progressStyle(options.progress, options.quiet));
    request.progress = [&](const TradeProgress& p) { showProgress(progress, p); };

    TradeResult result;
    try {
        result = measureTrade(request);
    } catch (const Stopped&) {
        return kInterrupted;
    }
    progress.clear();
    if (!options.folder.empty()) writeReports(result, options.folder);
    if (options.json)
        fmt::print("{}", tradeJson(result));
    else
        printSummary(result, options.scene.scene);
    if (!options.folder.empty() && !options.quiet)
        fmt::print(stderr, "wrote trade.html, trade.json and trade.csv into {}\n", options.folder);
    if (result.interrupted) return kInterrupted;
    return result.complete ? kSuccess : kStoppedByLimit;
}

}  // namespace

std::function<int()> setUpTrade(OptionList& list) {
    auto options = std::make_shared<TradeOptions>();
    options->scene.size = "200x200";
    options->scene.addTo(list, true);
    list.add("-o,--output", &options->folder, "Folder for the report: trade.html, trade.json, trade.csv");
    list.add("--budget", &options->budget, "Seconds to spend, half of them on the reference")
        .range(0.1, 1e6)
        .showDefault();
    list.add("--no-cache", &options->noCache,
             "Neither read nor write the reference cache ($XDG_CACHE_HOME/rayscope/references)");
    list.add("--progress", &options->progress, "bar, json or none").choices({"bar", "json", "none"});
    list.add("--json", &options->json, "Print the result as JSON");
    list.add("-q,--quiet", &options->quiet, "Print no progress and no notes");
    return [options] { return runTrade(*options); };
}

}  // namespace rayscope::cli
