#include <fmt/format.h>

#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>
#include <cmath>

#include <nlohmann/json.hpp>
#include "base/atomic_file.h"
#include "base/console.h"
#include "base/json_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/error_map_file.h"
#include "cli/output_files.h"
#include "cli/verdicts.h"
#include "post/display_transform.h"

namespace rayscope::cli {

namespace {

struct CompareCommandOptions {
    std::string image, reference, difference, map, metric = "rmse";
    std::optional<double> failAbove;
    double range = 0.0;
    int tile = 32;
    CompareOptions measure;
    VerdictOptions verdict;
    bool json = false;
};

nlohmann::json toJson(const ErrorMeasures& e) {
    return {{"rmse", e.rmse},
            {"relmse", e.relMse},
            {"relmse_trimmed", e.relMseTrimmed},
            {"smape", e.smape},
            {"max", e.maximum},
            {"max_at", {e.maximumX, e.maximumY}},
            {"mean_difference", e.meanDifference},
            {"ssim", e.ssim},
            {"flip", e.flip},
            {"pixels", e.pixels},
            {"pixels_compared", e.pixelsCompared},
            {"non_finite_a", e.nonFiniteImage},
            {"non_finite_b", e.nonFiniteReference}};
}

void printText(const ErrorMeasures& e) {
    base::print("rmse             {:.6g}\n", e.rmse);
    base::print("relmse           {:.6g}  ({:.6g} without the 0.1 % of the pixels with the largest error)\n",
                e.relMse, e.relMseTrimmed);
    base::print("smape            {:.6g}\n", e.smape);
    base::print("max              {:.6g}  at pixel {},{}\n", e.maximum, e.maximumX, e.maximumY);
    base::print("mean difference  {:+.6g}\n", e.meanDifference);
    base::print("ssim             {:.6g}\n", e.ssim);
    base::print("flip             {:.6g}\n", e.flip);
}

std::vector<MapRegion> tilesOf(const Image<double>& map, int size) {
    std::vector<MapRegion> tiles;
    for (int y = 0; y < map.height; y += size)
        for (int x = 0; x < map.width; x += size)
            tiles.push_back({x, std::min(x + size, map.width), y, std::min(y + size, map.height)});
    return tiles;
}

double rangeOf(const CompareCommandOptions& options, const Image<double>& map, ErrorMetric metric) {
    if (options.range > 0.0) return options.range;
    return metric == ErrorMetric::Flip ? 1.0 : scoreOf(map, ErrorMetric::Max);
}

void writeTiles(const CompareCommandOptions& options, const Image<double>& map, ErrorMetric metric) {
    std::string table = fmt::format("x0,x1,y0,y1,{}\n", nameOf(metric));
    Image<double> tiles(map.width, map.height);
    for (const MapRegion& tile : tilesOf(map, options.tile)) {
        const double score = scoreOf(map, metric, tile);
        table += fmt::format("{},{},{},{},{:.9g}\n", tile.x0, tile.x1, tile.y0, tile.y1, score);
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) tiles.at(x, y) = score;
    }
    if (options.map.ends_with(".csv"))
        base::writeFileAtomically(options.map, table);
    else
        writeErrorMap(options.map, tiles, rangeOf(options, tiles, metric));
}

/// Prints how many pixels are not finite. Returns whether there are any.
bool reportNonFinite(const CompareCommandOptions& options, const ErrorMeasures& errors) {
    const std::pair<const std::string*, long long> counts[] = {
        {&options.image, errors.nonFiniteImage}, {&options.reference, errors.nonFiniteReference}};
    for (const auto& [name, count] : counts)
        if (count > 0)
            base::printMessage(
                "{}: error: {} of {} pixels are NaN or infinite; they are excluded from the metrics\n",
                base::printable(*name), count, errors.pixels);
    return errors.nonFiniteImage + errors.nonFiniteReference > 0;
}

int runVerdict(const CompareCommandOptions& options, ErrorMetric metric) {
    if (!options.map.empty())
        throw UsageError("--map",
                         "writes the tiles of two images, without a verdict; leave out the options "
                         "of verdicts");
    measure::GradingRules rules = options.verdict.rules();
    rules.measure = options.measure;
    if (options.failAbove) rules.metrics.push_back({metric, *options.failAbove});
    return runVerdicts(options.image, options.reference, options.verdict, rules, options.difference,
                       options.json);
}

int runCompare(const CompareCommandOptions& options) {
    const ErrorMetric metric = errorMetricNamed(options.metric);
    if (options.verdict.isAsked() || isFolder(options.image) || isFolder(options.reference))
        return runVerdict(options, metric);
    Diagnostics notes;
    const RgbImage image = readImage(options.image, &notes);
    const RgbImage reference =
        options.reference == options.image ? image : readImage(options.reference, &notes);
    for (const Diagnostic& note : notes) base::printMessage("{}\n", toString(note));
    const ErrorMeasures errors = measureErrors(image, reference, options.measure);
    const Image<double> map = errorMap(image, reference, metric, options.measure);

    if (options.json)
        base::writeOutput(base::jsonText(toJson(errors)));
    else
        printText(errors);
    OutputFiles files;
    if (!options.difference.empty()) {
        const double range = rangeOf(options, map, metric);
        files.write(options.difference, [&] { writeErrorMap(options.difference, map, range); });
        if (post::isDisplayFormat(options.difference) && !options.json)
            base::print("{}: {} of each pixel, from black for 0 to white for {:.6g}\n",
                        base::printable(options.difference), options.metric, range);
    }
    if (!options.map.empty()) files.write(options.map, [&] { writeTiles(options, map, metric); });

    const bool nonFinite = reportNonFinite(options, errors);
    const double score = errors.of(metric);
    if (options.failAbove && !(score <= *options.failAbove)) {
        base::printMessage("error: {} is {:.6g}, above {:.6g}\n", options.metric, score, *options.failAbove);
        return files.exitCode(kThresholdExceeded);
    }
    return files.exitCode(nonFinite ? kNonFiniteImage : kSuccess);
}

}  // namespace

std::function<int()> setUpCompare(OptionList& list) {
    auto options = std::make_shared<CompareCommandOptions>();
    list.add("A", &options->image, "The image: .png .exr .pfm .hdr .jpg .ppm …; or a folder of images")
        .required();
    list.add("B", &options->reference, "The reference image, of the same size; or a folder of images")
        .required();
    list.add("-o,--output", &options->difference,
             "Write the error of each pixel as an image: in false colour (.png .ppm) or as values (.exr .pfm "
             ".hdr)")
        .writes(Option::Output::Image);
    list.add("--metric", &options->metric,
             "Metric of -o, --map and --fail-above: rmse, relmse, smape, max, ssim (as 1 - SSIM) or flip")
        .suggest([] { return std::vector<std::string>{"rmse", "relmse", "smape", "max", "ssim", "flip"}; })
        .showDefault();
    list.add("--fail-above", &options->failAbove, "Exit with 4 if the metric exceeds this value or is NaN")
        .atLeast(0.0);
    list.add("--map", &options->map,
             "Write the error of each tile: a table (.csv), an image in false colour (.png .ppm) or as "
             "values (.exr .pfm .hdr)")
        .writes(Option::Output::ImageOrTable);
    list.add("--tile", &options->tile, "Edge length of the tiles of --map, in pixels")
        .from(1, 1 << 16)
        .showDefault();
    list.add("--range", &options->range,
             "Value shown as white in false colour; by default the maximum, and 1 for flip")
        .above(0.0);
    list.add("--exposure", &options->measure.exposure, "Exposure before ssim and flip, in stops")
        .from(-20.0, 20.0);
    list.add("--pixels-per-degree", &options->measure.pixelsPerDegree,
             "Viewing distance for FLIP, in pixels per degree")
        .from(1.0, 1000.0)
        .showDefault();
    options->verdict.addTo(list);
    list.add("--json", &options->json, "Print JSON");
    list.setDetails(
        "rmse, relmse, smape and max compare linear values; ssim and flip compare what a display shows.\n"
        "An option of verdicts, or two folders, gives one line per pair of images, passes or fails, instead "
        "of "
        "the metrics, and exit code 4 if one fails. Images of folders are paired by name.");
    return [options] { return runCompare(*options); };
}

}  // namespace rayscope::cli
