#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/trade.h>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/shell_quote.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt_stop_source.h"
#include "cli/output_files.h"
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
    base::print("{} at {} x {}, {} threads: {} candidates, {} blocks, {:.1f} s\n", base::printable(scene),
                r.width, r.height, r.threads,
                std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return p.runs > 0; }),
                r.blocks, r.spentSeconds);
    base::print("reference: 2 x {} samples, RMSE {:.3g}{}\n", r.reference.samples, r.reference.error,
                r.reference.fromCache ? " (continued from the cache)" : "");
    if (r.complete) {
        base::print("timing noise of the machine: {:.1f} %\n", 100.0 * r.smallestTimeDifference);
        base::print("\nrecommended settings, with 95 % prediction intervals of one more run:\n");
    }
    for (const TradeAdvice& advice : r.advice) {
        const TradePoint& p = r.points[advice.point];
        base::print(
            "  {:.3g} s [{:.3g}, {:.3g}]  RMSE {:.3g} [{:.3g}, {:.3g}]\n    rayscope render {} {} -o OUT\n",
            p.predictedSeconds.value, p.predictedSeconds.lower, p.predictedSeconds.upper,
            p.predictedError.value, p.predictedError.lower, p.predictedError.upper,
            base::shellQuotePath(scene), renderArguments(r, p));
    }
    for (const TradePreset& preset : r.presetPoints)
        base::print("preset {}: {:.3g} s, RMSE {:.3g}, excess time over the Pareto front {}\n", preset.preset,
                    r.points[preset.point].seconds.value, r.points[preset.point].error.value,
                    excessText(r, preset));
    for (const std::string& remark : r.remarks) base::print("note: {}\n", base::printable(remark));
}

void writeReports(OutputFiles& files, const TradeResult& result, const std::string& folder) {
    const std::filesystem::path path(folder);
    using Report = std::string (*)(const TradeResult&);
    const std::pair<const char*, Report> reports[] = {
        {"trade.json", tradeJson}, {"trade.csv", tradeCsv}, {"trade.html", tradeHtml}};
    for (const auto& [name, report] : reports) {
        const std::string file = (path / name).string();
        files.write(file, [&, make = report] { base::writeFileAtomically(file, make(result)); });
    }
}

int runTrade(const TradeOptions& options) {
    InterruptStopSource interrupt;
    TradeRequest request;
    request.render = openScene(options.scene, options.quiet, progressStyle(options.progress, options.quiet));
    request.budgetSeconds = options.budget;
    request.threads = options.scene.threads;
    request.stop = interrupt.token();
    if (!options.noCache) request.cacheFolder = referenceCacheFolder();
    Progress progress(progressStyle(options.progress, options.quiet));
    request.progress = [&](const TradeProgress& p) { showProgress(progress, p); };

    TradeResult result;
    interrupt.keepResult("interrupted: the reports of the measurements so far are written");
    try {
        result = measureTrade(request);
    } catch (const Stopped&) {
        return kInterrupted;
    }
    progress.clear();
    OutputFiles files;
    if (!options.folder.empty()) writeReports(files, result, options.folder);
    if (options.json)
        base::writeOutput(tradeJson(result));
    else
        printSummary(result, options.scene.scene);
    if (!options.folder.empty() && !options.quiet && !files.failed())
        base::printMessage("wrote trade.html, trade.json and trade.csv into {}\n",
                           base::printable(options.folder));
    if (result.interrupted) return kInterrupted;
    return files.exitCode(result.complete ? kSuccess : kStoppedByLimit);
}

}  // namespace

std::function<int()> setUpTrade(OptionList& list) {
    auto options = std::make_shared<TradeOptions>();
    options->scene.size = {200, 200};
    options->scene.addTo(list, true);
    list.add("-o,--output", &options->folder, "Folder for the report: trade.html, trade.json, trade.csv")
        .writes(Option::Output::Folder);
    list.add("--budget", &options->budget, "Seconds to spend, half of them on the reference")
        .from(0.1, 1e6)
        .showDefault();
    list.add("--no-cache", &options->noCache,
             "Neither read nor write the reference cache ($XDG_CACHE_HOME/rayscope/references)");
    addProgressTo(list, options->progress);
    list.add("--json", &options->json, "Print the result as JSON");
    list.add("-q,--quiet", &options->quiet, "Print no progress and no notes");
    return [options] { return runTrade(*options); };
}

}  // namespace rayscope::cli
