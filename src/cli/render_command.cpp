#include <fmt/format.h>

#include <rayscope/probe.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "base/atomic_file.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/number_list.h"
#include "cli/progress.h"
#include "cli/render_stats.h"
#include "cli/scene_options.h"
#include "cli/target_options.h"
#include "math/vectors.h"
#include "post/display_transform.h"
#include "probe/aov.h"
#include "probe/non_finite.h"
#include "render/film.h"
#include "render/image_metadata.h"
#include "trace/world.h"

namespace rayscope::cli {

namespace {

struct RenderOptions {
    SceneOptions scene;
    TargetOptions target;
    std::vector<std::string> outputs;
    std::string pixelBounds, statsFile, progress;
    std::vector<std::string> aovs;
    double timeLimit = 0.0;
    bool quiet = false, dumpSettings = false;
};

std::optional<PixelBounds> regionFor(const RenderOptions& options, const RenderRequest& request) {
    if (options.pixelBounds.empty()) return std::nullopt;
    const std::vector<double> n = parseNumbers("--pixelbounds", options.pixelBounds, ',', 4);
    const PixelBounds region{static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2]),
                             static_cast<int>(n[3])};
    const bool inside = region.x0 >= 0 && region.x0 < region.x1 && region.x1 <= request.width &&
                        region.y0 >= 0 && region.y0 < region.y1 && region.y1 <= request.height;
    if (!inside)
        throw UsageError("--pixelbounds",
                         fmt::format("expected 0 <= X0 < X1 <= {} and 0 <= Y0 < Y1 <= {}, got '{}'",
                                     request.width, request.height, options.pixelBounds));
    return region;
}

/// Waits for the session, telling how far it is, until it is done, interrupted or out of time.
int waitFor(RenderSession& session, const RenderOptions& options, const InterruptGuard& interrupt,
            Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    for (;;) {
        const RenderState state = session.wait(0.05);
        const RenderStatus status = session.status();
        if (state == RenderState::Failed) throw InputError(status.message);
        if (state == RenderState::Done) {
            progress.finish(status);
            return kSuccess;
        }
        const double elapsed =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const bool outOfTime = options.timeLimit > 0.0 && elapsed >= options.timeLimit;
        if (interrupt.interrupted() || outOfTime) {
            session.finishTiles();
            session.wait();
            progress.finish(session.status());
            return interrupt.interrupted() ? kInterrupted : kStoppedByLimit;
        }
        progress.show(status);
    }
}

/// What came out, whichever way it was rendered.
struct Rendered {
    RgbImage mean;
    RenderStatus status;
    std::shared_ptr<const trace::World> world;
    std::shared_ptr<const render::Film> film;  ///< null if rendered to a target
    int exitCode = kSuccess;
    std::string words;  ///< why it stopped, if that is worth a line
};

/// Beside the first output: "image.nodes.exr". Numbers do not fit into a PNG.
std::string aovPath(const std::string& output, std::string_view name) {
    std::filesystem::path path(output);
    const std::string suffix = path.extension() == ".pfm" ? ".pfm" : ".exr";
    path.replace_extension(fmt::format(".{}{}", name, suffix));
    return path.string();
}

void writeAovs(const RenderOptions& options, const std::vector<probe::Aov>& wanted,
               const RenderRequest& request, const Rendered& rendered, const ImageMetadata& metadata) {
    if (wanted.empty() || !rendered.world || !rendered.film) return;
    const int samples = std::max(1, rendered.film->completeSamples());
    const probe::AovRequest job{*rendered.world, rendered.film.get(), request.seed,
                                samples,         request.region,      options.scene.threads};
    const std::vector<RgbImage> images = probe::renderAovs(job, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        writeImage(aovPath(options.outputs.front(), probe::infoOf(wanted[i]).name), images[i], metadata);
}

/// The first sample of a pixel that is not finite, and why; sample 0 if none is by itself.
struct BadSample {
    int index = 0;
    std::string cause = "the sum of its samples overflows";
};

BadSample firstBadSample(const Rendered& rendered, const RenderRequest& request, glm::ivec2 pixel) {
    int samples = rendered.status.samples;
    if (rendered.film) rendered.film->sums(pixel.x, pixel.y, samples);
    for (int index = 0; index < samples; ++index) {
        const RayTree tree = probeSample(*rendered.world, request.seed, {pixel.x, pixel.y, index});
        if (std::string cause = probe::causeOfNonFinite(tree, *rendered.world); !cause.empty())
            return {index, cause};
    }
    return {};
}

/// Names the pixels that are not numbers, and says why the first is none and how to look into it.
bool reportNonFinite(const RenderOptions& options, const RenderRequest& request, const Rendered& rendered) {
    const RgbImage& image = rendered.mean;
    constexpr int kNamed = 8;
    int count = 0;
    std::string names;
    glm::ivec2 first(0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (math::isFinite(image.at(x, y))) continue;
            if (count == 0) first = {x, y};
            if (count++ < kNamed) names += fmt::format(" ({}, {})", x, y);
        }
    }
    if (count == 0) return false;
    const BadSample bad = firstBadSample(rendered, request, first);
    fmt::print(stderr, "error: {} pixels are NaN or infinite:{}{}; in the first, {}; look into it with: {}\n",
               count, names, count > kNamed ? " …" : "", bad.cause,
               probeCommand(options.scene, first, bad.index));
    return true;
}

Rendered renderSamples(RenderRequest& request, const RenderOptions& options,
                       const InterruptGuard& interrupt) {
    // With a limit the image should be complete early; without one, larger passes cost less.
    request.progressive = options.timeLimit > 0.0;
    RenderSession session(options.scene.threads);
    Progress progress(progressStyle(options.progress, options.quiet));
    session.submit(request);
    Rendered rendered;
    rendered.exitCode = waitFor(session, options, interrupt, progress);
    rendered.status = session.status();
    rendered.world = session.world();
    rendered.film = session.film();
    rendered.mean = rendered.film ? rendered.film->mean() : RgbImage(request.width, request.height);
    if (rendered.exitCode == kStoppedByLimit)
        rendered.words = fmt::format("stopped by the time limit at {:.1f} % of {} samples per pixel",
                                     100.0 * rendered.status.progress, rendered.status.targetSamples);
    return rendered;
}

Rendered renderUntilAccurate(const RenderRequest& request, const RenderOptions& options,
                             const InterruptGuard& interrupt) {
    ErrorTargetResult result =
        renderToTarget(request, options.target, options.timeLimit, options.scene.spp.value_or(0),
                       options.scene.threads, interrupt, progressStyle(options.progress, options.quiet));
    Rendered rendered;
    rendered.exitCode = result.reason == StopReason::Reached       ? kSuccess
                        : result.reason == StopReason::Interrupted ? kInterrupted
                                                                   : kStoppedByLimit;
    rendered.status.samples = static_cast<int>(std::lround(result.samples));
    rendered.status.elapsedSeconds = result.seconds;
    rendered.status.rays = result.rays;
    rendered.status.nonFiniteSamples = result.nonFiniteSamples;
    rendered.status.buildSeconds = result.world->buildSeconds;
    rendered.world = result.world;
    rendered.mean = std::move(result.mean);
    if (!options.quiet || result.reason != StopReason::Reached) rendered.words = result.words;
    return rendered;
}

int runRender(const RenderOptions& options) {
    const InterruptGuard interrupt;
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& output : options.outputs) checkImageDestination(output);
    RenderRequest request = openScene(options.scene, options.quiet);
    if (options.dumpSettings) {
        fmt::print("{}", dumpSettings(request.settings));
        return kSuccess;
    }
    if (options.outputs.empty()) throw UsageError("-o/--output is required");
    request.region = regionFor(options, request);
    std::vector<probe::Aov> aovs;
    for (const std::string& name : options.aovs) aovs.push_back(probe::aovNamed(name));
    for (const probe::Aov aov : aovs)
        checkImageDestination(aovPath(options.outputs.front(), probe::infoOf(aov).name));
    if (!aovs.empty() && options.target.wanted())
        throw UsageError("--aov", "needs a fixed number of samples: leave out --target-error");
    request.keepBinaryTrees = !aovs.empty();

    const Rendered rendered = options.target.wanted() ? renderUntilAccurate(request, options, interrupt)
                                                      : renderSamples(request, options, interrupt);
    const RgbImage& mean = rendered.mean;
    const RenderStatus& status = rendered.status;
    int exitCode = rendered.exitCode;
    const ImageMetadata metadata =
        render::imageMetadata(*request.scene, request.settings, request.seed, status.samples);
    for (const std::string& output : options.outputs)
        writeImage(output, post::develop(mean, request.settings, post::isDisplayFormat(output)), metadata,
                   request.settings.tone);
    if (exitCode != kInterrupted) writeAovs(options, aovs, request, rendered, metadata);
    if (!options.statsFile.empty() && rendered.world) {
        const double total = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const int threads = options.scene.threads > 0 ? options.scene.threads
                                                      : static_cast<int>(std::thread::hardware_concurrency());
        base::writeFileAtomically(options.statsFile,
                                  renderStatsJson(request, status, *rendered.world, threads, total));
    }
    if (!rendered.words.empty()) fmt::print(stderr, "{}\n", rendered.words);
    if (reportNonFinite(options, request, rendered) && exitCode != kInterrupted) exitCode = kNonFiniteImage;
    return exitCode;
}

}  // namespace

std::function<int()> setUpRender(OptionList& list) {
    auto options = std::make_shared<RenderOptions>();
    options->scene.addTo(list, true);
    list.add("-o,--output", &options->outputs, "Image to write, .png .exr .pfm or .hdr; repeatable");
    list.add("--time-limit", &options->timeLimit, "Stop after this many seconds with the best image so far")
        .positive();
    options->target.addTo(list);
    list.add("--pixelbounds", &options->pixelBounds,
             "Render only X0,X1,Y0,Y1 (half-open, from the top left)");
    std::vector<std::string_view> names;
    for (const probe::AovInfo& info : probe::aovTable()) names.push_back(info.name);
    list.add(
            "--aov", &options->aovs,
            fmt::format("AOVs to write beside the first output, as NAME.AOV.exr: {}", fmt::join(names, ", ")))
        .separatedBy(',');
    list.add("--stats", &options->statsFile, "Write counts and times as JSON");
    list.add("--progress", &options->progress, "bar, json or none").choices({"bar", "json", "none"});
    list.add("-q,--quiet", &options->quiet, "Print errors only");
    list.add("--dump-settings", &options->dumpSettings,
             "Print the settings that differ from the defaults, and exit");
    return [options] { return runRender(*options); };
}

}  // namespace rayscope::cli
