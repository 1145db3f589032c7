#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/lab.h>
#include <filesystem>

#include "base/atomic_file.h"
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
    if (options.scene.scene.empty()) {
        request.scene = std::make_shared<SceneDescription>(labShapes());
        for (const SettingAssignment& assignment : parseAssignments(options.scene))
            assign(request.settings, assignment.key, assignment.value);
    } else {
        const RenderRequest opened = openScene(options.scene, options.quiet);
        request.scene = opened.scene;
        request.settings = opened.settings;
    }
    request.raysPerTestPoint = options.rays;
    request.quick = options.quick;
    request.seed = options.scene.seed;
    request.threads = options.scene.threads;
    return request;
}

void showProgress(ProgressStyle style, double fraction, double remaining) {
    if (style == ProgressStyle::Json)
        fmt::print(stderr, "{{\"progress\":{:.4f},\"remaining_s\":{:.1f}}}\n", fraction, remaining);
    if (style == ProgressStyle::Bar) showProgressBar(fraction, "", remaining);
}

int runLabCommand(const LabOptions& options) {
    if (!options.folder.empty()) {
        std::error_code error;
        std::filesystem::create_directories(options.folder, error);
        base::checkFileDestination((std::filesystem::path(options.folder) / "lab.json").string());
    }
    const InterruptStopSource interrupt;
    LabRequest request = requestOf(options);
    request.stop = interrupt.token();
    const ProgressStyle style = progressStyle(options.progress, options.quiet);
    request.progress = [style](double fraction, double remaining) {
        showProgress(style, fraction, remaining);
    };

    const LabResult result = runLab(request);
    if (style == ProgressStyle::Bar) fmt::print(stderr, "\r\033[K");
    fmt::print("{}", options.json ? labJson(result) : labText(result));
    if (!options.folder.empty()) {
        const std::vector<std::string> commands = writeLab(result, *request.scene, options.folder);
        if (!options.quiet)
            fmt::print(stderr, "wrote lab.html, lab.json and lab.csv into {}\n", options.folder);
        if (!options.quiet && !commands.empty())
            fmt::print(stderr, "commands that trace the failing rays of each method with Rayscope:\n");
        for (const std::string& command : commands)
            if (!options.quiet) fmt::print(stderr, "  {}\n", command);
    }
    if (result.interrupted) return kInterrupted;
    return result.range(LabMethod::Rayscope).failingTestPoints > 0 ? kThresholdExceeded : kSuccess;
}

}  // namespace

void addLabCommand(CLI::App& program, int& exitCode) {
    auto options = std::make_shared<LabOptions>();
    CLI::App* command = program.add_subcommand(
        "lab",
        "Numerical robustness: intersect the triangles of a scene (or generated shapes) at many scales and "
        "offsets, and compare with exact arithmetic. Exit code 4 if Rayscope fails");
    options->scene.addSceneTo(*command, false);
    command->add_option("--seed", options->scene.seed, "Seed of the random numbers")->capture_default_str();
    command->add_option(
        "-o,--output", options->folder,
        "Folder for the report: lab.html, lab.json, lab.csv, and failing rays for 'rayscope cast'");
    command
        ->add_option("--rays", options->rays,
                     "Rays per test point at shared edges and vertices; half as many spawned rays are added")
        ->check(CLI::Range(1, 1000000000))
        ->capture_default_str();
    command->add_flag("--quick", options->quick, "A coarse grid of scales and offsets");
    command->add_option("--progress", options->progress, "bar, json or none")
        ->check(CLI::IsMember({"bar", "json", "none"}));
    command->add_flag("--json", options->json, "Print the result as JSON");
    command->add_flag("-q,--quiet", options->quiet, "Print no progress and no notes");
    command->callback([options, &exitCode] { exitCode = runLabCommand(*options); });
}

}  // namespace rayscope::cli
