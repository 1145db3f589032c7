#include <fmt/format.h>

#include <rayscope/aov.h>
#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>
#include <rayscope/render_image.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/printable_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt_stop_source.h"
#include "cli/non_finite_report.h"
#include "cli/output_files.h"
#include "cli/part_options.h"
#include "cli/progress.h"
#include "cli/render_stats.h"
#include "cli/scene_options.h"
#include "cli/target_options.h"
#include "image/encode_image.h"
#include "post/rendered_outputs.h"
#include "render/thread_arena.h"
#include "render/tile_stop.h"
#include "trace/world.h"

namespace rayscope::cli {

namespace {

struct RenderCommandOptions {
    SceneOptions scene;
    TargetOptions target;
    PartOptions part;
    std::vector<std::string> outputs;
    std::optional<glm::ivec4> pixelBounds;  ///< x0, x1, y0, y1
    std::string statsFile, progress;
    std::string format;  ///< of the image on the standard output
    std::vector<std::string> aovs;
    double timeLimit = 0.0;
    bool quiet = false, dumpSettings = false;
};

std::optional<PixelBounds> regionFor(const RenderCommandOptions& options, const RenderRequest& request) {
    if (!options.pixelBounds) return std::nullopt;
    const glm::ivec4& bounds = *options.pixelBounds;
    const PixelBounds region{bounds[0], bounds[1], bounds[2], bounds[3]};
    const bool inside = region.x0 < region.x1 && region.x1 <= request.width && region.y0 < region.y1 &&
                        region.y1 <= request.height;
    if (!inside)
        throw UsageError(
            "--pixelbounds",
            fmt::format("expected 0 <= X0 < X1 <= {} and 0 <= Y0 < Y1 <= {}, got '{},{},{},{}'",
                        request.width, request.height, bounds[0], bounds[1], bounds[2], bounds[3]));
    return region;
}

void show(Progress& progress, const RenderStatus& status) {
    const bool isCompiling = status.state == RenderState::Compiling;
    ProgressReport report{{},
                          "building …",
                          {{"progress", status.progress},
                           {"samples", static_cast<std::uint64_t>(status.samples)},
                           {"target_samples", static_cast<std::uint64_t>(status.targetSamples)},
                           {"elapsed_s", status.elapsedSeconds},
                           {"remaining_s", status.remainingSeconds},
                           {"rays", status.rays}}};
    if (!isCompiling) {
        report.fraction = status.progress;
        report.text = fmt::format("{} of {} samples  {}  {}", status.samples, status.targetSamples,
                                  durationText(status.elapsedSeconds), etaText(status.remainingSeconds));
    }
    progress.show(report);
}

/// The image and how the render ended.
struct Rendered {
    RenderedImage image;
    int exitCode = kSuccess;
    std::string message;  ///< why it stopped; may be empty
};

/// Beside the first output: "image.nodes.exr". Numbers do not fit into a PNG.
std::string aovPath(const std::string& output, std::string_view name) {
    std::filesystem::path path(output);
    const std::string suffix = path.extension() == ".pfm" ? ".pfm" : ".exr";
    path.replace_extension(fmt::format(".{}{}", name, suffix));
    return path.string();
}

constexpr std::string_view kStandardOutput = "-";

void checkAovDestination(const RenderCommandOptions& options, const std::string& path) {
    checkImageDestination(path);
    std::vector<std::string> others = options.outputs;
    if (!options.statsFile.empty()) others.push_back(options.statsFile);
    for (const std::string& other : others)
        if (isSameFile(path, other))
            throw UsageError("--aov",
                             fmt::format("{} is also written by another option", base::quoted(path)));
}

/// What can be checked without the scene, so that a mistake costs no time.
void checkOptions(const RenderCommandOptions& options) {
    errorMetricNamed(options.target.metric);
    options.part.check();
    if (options.dumpSettings) return;
    if (options.part.wanted()) {
        const bool hasOthers = !options.outputs.empty() || !options.aovs.empty() || options.timeLimit > 0.0 ||
                               !options.statsFile.empty() || options.target.wanted();
        if (hasOthers)
            throw UsageError("--part",
                             "cannot be combined with -o, --aov, --stats, --time-limit and --target-error");
        return;
    }
    if (options.outputs.empty()) throw UsageError("-o/--output is required");
    const bool usesStandardOutput = std::ranges::count(options.outputs, kStandardOutput) > 0;
    if (usesStandardOutput && options.format.empty())
        throw UsageError(
            "--output",
            "'-' writes the image to the standard output and needs --format png, exr, pfm, hdr, ppm or pgm");
    if (usesStandardOutput && isatty(STDOUT_FILENO) == 1)
        throw UsageError("--output", "the standard output is a terminal; redirect it to a file or a pipe");
    if (!usesStandardOutput && !options.format.empty())
        throw UsageError("--format", "is the format of '-o -'; files have that of their suffix");
    if (options.aovs.empty()) return;
    if (options.target.wanted())
        throw UsageError("--aov", "needs a fixed number of samples: leave out --target-error");
    if (options.outputs.front() == kStandardOutput)
        throw UsageError("--aov", "AOVs are named after the first output, which must be a file");
    for (const std::string& name : options.aovs)
        checkAovDestination(options, aovPath(options.outputs.front(), infoOf(aovNamed(name)).name));
}

/// Throws Stopped.
void writeAovs(OutputFiles& files, const RenderCommandOptions& options, const RenderedImage& image,
               const ImageMetadata& metadata, const std::stop_token& stop,
               const std::stop_token& compressing) {
    if (options.aovs.empty() || !image.world) return;
    std::vector<RgbImage> images;
    files.write(aovPath(options.outputs.front(), options.aovs.front()), [&] {
        images = renderAovs(image, options.aovs, {options.scene.threads, stop});
    });
    if (images.empty()) return;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const std::string path = aovPath(options.outputs.front(), options.aovs[i]);
        files.write(path, [&] { image::writeImage(path, images[i], metadata, Encoding::Srgb, compressing); });
    }
}

void writeImages(OutputFiles& files, const RenderCommandOptions& options, const post::RenderedOutputs& images,
                 const ImageMetadata& metadata) {
    for (const std::string& output : options.outputs)
        files.write(output, [&] {
            if (output == kStandardOutput)
                base::writeOutput(images.encode("." + options.format, metadata));
            else
                images.write(output, metadata);
        });
}

Rendered renderSamples(const RenderRequest& request, const RenderCommandOptions& options,
                       const InterruptStopSource& interrupt) {
    Progress progress(progressStyle(options.progress, options.quiet));
    Rendered rendered;
    rendered.image = renderImage(request, {options.scene.threads, options.timeLimit, interrupt.token(),
                                           [&](const RenderStatus& status) { show(progress, status); }});
    progress.keep();
    if (rendered.image.isComplete()) return rendered;
    rendered.exitCode = interrupt.interrupted() ? kInterrupted : kStoppedByLimit;
    const RenderStatus& status = rendered.image.status;
    if (rendered.exitCode == kStoppedByLimit)
        rendered.message = fmt::format("stopped by the time limit at {:.1f} % of {} samples per pixel",
                                       100.0 * status.progress, status.targetSamples);
    return rendered;
}

Rendered renderUntilAccurate(const RenderRequest& request, const RenderCommandOptions& options,
                             const InterruptStopSource& interrupt) {
    ErrorTargetResult result = renderToTarget(
        request, options.target,
        {options.timeLimit, options.scene.spp.value_or(0), options.scene.threads, interrupt.token()},
        progressStyle(options.progress, options.quiet));
    Rendered rendered;
    rendered.exitCode = result.reason == StopReason::Reached       ? kSuccess
                        : result.reason == StopReason::Interrupted ? kInterrupted
                                                                   : kStoppedByLimit;
    RenderedImage& image = rendered.image;
    image.request = request;
    image.status.samples = static_cast<int>(std::lround(result.samples));
    image.status.elapsedSeconds = result.seconds;
    image.status.rays = result.rays;
    image.status.nonFiniteSamples = result.nonFiniteSamples;
    if (result.world) image.status.buildSeconds = result.world->buildReport.seconds;
    image.world = result.world;
    image.mean = std::move(result.mean);
    if (!options.quiet || result.reason != StopReason::Reached) rendered.message = result.text;
    return rendered;
}

void writeStats(const RenderCommandOptions& options, const RenderedImage& image, double seconds) {
    if (options.statsFile.empty() || !image.world) return;
    const int threads = render::ThreadArena::countFor(options.scene.threads);
    base::writeFileAtomically(options.statsFile,
                              renderStatsJson(image.request, image.status, *image.world, threads, seconds));
}

int runRender(const RenderCommandOptions& options) {
    InterruptStopSource interrupt;
    const auto start = std::chrono::steady_clock::now();
    checkOptions(options);
    RenderRequest request =
        openScene(options.scene, options.quiet, progressStyle(options.progress, options.quiet));
    if (options.dumpSettings) {
        base::print("{}", dumpSettings(request.settings));
        return kSuccess;
    }
    request.region = regionFor(options, request);
    request.keepBinaryTrees = false;
    if (options.part.wanted()) {
        renderPart(request, options.part, options.scene.threads,
                   progressStyle(options.progress, options.quiet), interrupt.token());
        return kSuccess;
    }
    interrupt.keepResult(
        "interrupted: the image so far is processed and written; a second interrupt ends the program without "
        "it");

    Rendered rendered = options.target.wanted() ? renderUntilAccurate(request, options, interrupt)
                                                : renderSamples(request, options, interrupt);
    const RenderedImage& image = rendered.image;
    const render::TileStop hurry({}, interrupt.token(), std::chrono::milliseconds(250));
    OutputFiles files;
    std::optional<post::RenderedOutputs> images;
    files.write(options.outputs.front(),
                [&] { images.emplace(image.mean, request.settings, hurry.token()); });
    if (images && images->lacksBloom()) {
        base::printMessage("interrupted: the image is written without bloom\n");
        rendered.exitCode = kInterrupted;
        request.settings = images->settings();
    }
    const ImageMetadata metadata = metadataOf(request, image.status.samples);
    if (images) writeImages(files, options, *images, metadata);
    try {
        writeAovs(files, options, image, metadata, interrupt.token(), hurry.token());
    } catch (const Stopped&) {
        rendered.exitCode = kInterrupted;
    }
    files.write(options.statsFile, [&] {
        writeStats(options, image,
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    });
    if (!rendered.message.empty()) base::printMessage("{}\n", rendered.message);
    const bool isFinite = !reportNonFinite(image);
    return files.exitCode(isFinite || rendered.exitCode == kInterrupted ? rendered.exitCode
                                                                        : kNonFiniteImage);
}

}  // namespace

std::function<int()> setUpRender(OptionList& list) {
    auto options = std::make_shared<RenderCommandOptions>();
    options->scene.addTo(list, true);
    list.add("-o,--output", &options->outputs,
             "Image to write, .png .exr .pfm .hdr .ppm or .pgm, or - for the standard output; repeatable")
        .writes(Option::Output::ImageOrStandardOutput);
    list.add("--format", &options->format, "Format of -o -")
        .choices({"png", "exr", "pfm", "hdr", "ppm", "pgm"});
    list.add("--time-limit", &options->timeLimit, "Stop after this many seconds with the best image so far")
        .above(0.0)
        .atMost(1e9);
    options->target.addTo(list);
    options->part.addTo(list);
    list.add("--pixelbounds", &options->pixelBounds,
             "Render only this half-open rectangle of pixels, from the top left")
        .form("X0,X1,Y0,Y1", ',')
        .from(0, 1 << 20);
    list.add("--aov", &options->aovs,
             fmt::format("AOVs to write beside the first output, as NAME.AOV.exr: {}",
                         fmt::join(aovNames(), ", ")))
        .form("NAME[,NAME]", ',');
    list.add("--stats", &options->statsFile, "Write counts and times as JSON").writes(Option::Output::File);
    addProgressTo(list, options->progress);
    list.add("-q,--quiet", &options->quiet, "Print errors only");
    list.add("--dump-settings", &options->dumpSettings,
             "Print the settings that differ from the defaults, and exit");
    return [options] { return runRender(*options); };
}

}  // namespace rayscope::cli
