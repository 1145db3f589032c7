#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/lab.h>

#include "base/console.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt_stop_source.h"
#include "cli/progress.h"
#include "cli/scene_options.h"

namespace rayscope::cli {

namespace {

struct LabOptions {
    SceneOptions scene;
    std::string folder, progress;
    int rays = 2000;
    bool quick = false, json = false, quiet = false;
};

LabRequest requestOf(const LabOptions& options) {
    LabRequest request;
    const RenderRequest opened =
        options.scene.scene.empty()
            ? requestFor(std::make_shared<SceneDescription>(labShapes()), overridesOf(options.scene))
            : openScene(options.scene, options.quiet, progressStyle(options.progress, options.quiet));
    request.scene = opened.scene;
    request.settings = opened.settings;
    request.raysPerTestPoint = options.rays;
    request.quick = options.quick;
    request.seed = options.scene.seed;
    request.threads = options.scene.threads;
    return request;
}

void showProgress(Progress& progress, double fraction, double remaining) {
    progress.show({fraction, etaText(remaining), {{"progress", fraction}, {"remaining_s", remaining}}});
}

int runLabCommand(const LabOptions& options) {
    InterruptStopSource interrupt;
    LabRequest request = requestOf(options);
    request.stop = interrupt.token();
    Progress progress(progressStyle(options.progress, options.quiet));
    request.progress = [&](double fraction, double remaining) {
        showProgress(progress, fraction, remaining);
    };

    interrupt.keepResult("interrupted: the reports of the finished test points are written");
    const LabResult result = runLab(request);
    progress.clear();
    if (options.json)
        base::writeOutput(labJson(result));
    else
        base::print("{}", labText(result));
    if (!options.folder.empty()) {
        const std::vector<std::string> commands = writeLab(result, *request.scene, options.folder);
        if (!options.quiet)
            base::printMessage("wrote lab.html, lab.json and lab.csv into {}\n",
                               base::printable(options.folder));
        if (!options.quiet && !commands.empty())
            base::printMessage("commands that trace the failing rays of each method with Rayscope:\n");
        for (const std::string& command : commands)
            if (!options.quiet) base::printMessage("  {}\n", command);
    }
    if (result.interrupted) return kInterrupted;
    return result.range(LabMethod::Rayscope).failingTestPoints > 0 ? kThresholdExceeded : kSuccess;
}

}  // namespace

std::function<int()> setUpLab(OptionList& list) {
    auto options = std::make_shared<LabOptions>();
    options->scene.addSceneTo(list, false);
    list.add("--seed", &options->scene.seed, "Seed of the random numbers").showDefault();
    list.add("-o,--output", &options->folder,
             "Folder for the report: lab.html, lab.json, lab.csv, and failing rays for 'rayscope cast'")
        .writes(Option::Output::Folder);
    list.add("--rays", &options->rays,
             "Rays per test point at shared edges and vertices; half as many spawned rays are added")
        .from(1, 1000000000)
        .showDefault();
    list.add("--quick", &options->quick, "A coarse grid of scales and offsets");
    addProgressTo(list, options->progress);
    list.add("--json", &options->json, "Print the result as JSON");
    list.add("-q,--quiet", &options->quiet, "Print no progress and no notes");
    list.setDetails(
        "Intersects the triangles of the scene, or of generated shapes without one, at many scales and "
        "offsets "
        "and compares the hits with exact arithmetic. Exit code 4 if Rayscope fails.");
    return [options] { return runLabCommand(*options); };
}

}  // namespace rayscope::cli
