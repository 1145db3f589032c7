#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <rayscope/display.h>
#include <rayscope/render_image.h>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/non_finite_report.h"
#include "cli/output_files.h"
#include "cli/scene_options.h"
#include "measure/parts/film_part.h"
#include "measure/trade/content_hash.h"
#include "trace/compile.h"

namespace rayscope::cli {

namespace {

struct MergeCommandOptions {
    SceneOptions scene;
    std::vector<std::string> parts, outputs;
    bool quiet = false;
};

/// "part 3 of 8 is missing", "parts 3 and 7 of 8 are missing".
std::string missingText(const std::vector<int>& missing, int parts) {
    if (missing.size() == 1) return fmt::format("part {} of {} is missing", missing.front(), parts);
    const std::vector<int> first(missing.begin(), missing.end() - 1);
    return fmt::format("parts {} and {} of {} are missing", fmt::join(first, ", "), missing.back(), parts);
}

int runMerge(const MergeCommandOptions& options) {
    RenderRequest request = openScene(options.scene, options.quiet, progressStyle("", options.quiet));
    const measure::FilmPartHeader first = measure::readFilmPartHeader(options.parts.front());
    const PixelBounds whole{0, request.width, 0, request.height};
    const bool isWhole = first.region == PixelBounds{0, first.width, 0, first.height};
    if (!isWhole) request.region = first.region;
    request.keepBinaryTrees = false;
    measure::FilmPartHeader expected = first;
    const auto world = compileScene(request);
    expected.contentHash = measure::filmContentHash(
        {request.scene, request.settings, request.camera, request.width, request.height}, *world);
    expected.seed = request.seed;
    expected.samples = request.settings.spp;
    expected.width = request.width;
    expected.height = request.height;
    if (isWhole) expected.region = whole;
    const bool isSameSize = first.width == request.width && first.height == request.height;
    const PixelBounds region = isSameSize ? expected.region : whole;
    render::Film::requireMemory(region, 1, request.settings.bloom ? 5 : 3);
    const auto film = std::make_shared<render::Film>(request.width, request.height, region);
    measure::FilmPartMerger merger(expected, *film);
    for (const std::string& part : options.parts) merger.add(part);
    if (const std::vector<int> missing = merger.missing(); !missing.empty())
        throw InputError(missingText(missing, first.parts));
    RenderedImage image;
    image.request = request;
    image.status.samples = request.settings.spp;
    image.world = world;
    image.film = film;
    image.mean = film->mean();
    const ImageMetadata metadata = metadataOf(request, request.settings.spp);
    OutputFiles files;
    for (const std::string& output : options.outputs)
        files.write(output, [&] { writeRenderedImage(output, image.mean, request.settings, metadata); });
    return files.exitCode(reportNonFinite(image) ? kNonFiniteImage : kSuccess);
}

}  // namespace

std::function<int()> setUpMerge(OptionList& list) {
    auto options = std::make_shared<MergeCommandOptions>();
    options->scene.addTo(list, true);
    list.add("PARTS", &options->parts, "Files of 'render --part', one of each part, in any order").required();
    list.add("-o,--output", &options->outputs, "Image to write, .png .exr .pfm .hdr .ppm or .pgm; repeatable")
        .required()
        .writes(Option::Output::Image);
    list.add("-q,--quiet", &options->quiet, "Print errors only");
    list.setDetails(
        "Scene and options must be those of the parts; --pixelbounds is taken from them. The image has the "
        "bits of one render.");
    return [options] { return runMerge(*options); };
}

}  // namespace rayscope::cli
