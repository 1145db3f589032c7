#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/json_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/output_files.h"
#include "cli/scene_options.h"
#include "math/vectors.h"
#include "measure/bench/bench.h"
#include "measure/bench/embree_baseline.h"
#include "measure/bench/picture_bench.h"
#include "render/thread_arena.h"
#include "trace/compile.h"
#include "trace/motion_group.h"

namespace rayscope::cli {

namespace {

struct BenchCommandOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> assignments;
    std::string jsonFile;
    int threads = 0, size = 1024, rounds = 7;
};

nlohmann::json json(const Interval& interval) {
    return {{"median", interval.value}, {"low", interval.lower}, {"high", interval.upper}};
}

nlohmann::json json(const measure::RayTiming& timing) {
    nlohmann::json row = {{"rays", timing.rays},
                          {"hits", timing.hits},
                          {"mrays_per_s", timing.single},
                          {"batched_mrays_per_s", timing.batched},
                          {"batched_to_single", json(timing.batchedToOwnSingle)}};
    if (timing.nodes > 0.0)
        row["per_ray"] = {{"nodes", timing.nodes},
                          {"leaves", timing.leaves},
                          {"primitives", timing.primitives},
                          {"exact_tests", timing.exact}};
    if (timing.embreeSingle > 0.0)
        row.update({{"embree_mrays_per_s", timing.embreeSingle},
                    {"embree_robust_mrays_per_s", timing.embreeRobust},
                    {"embree_packet16_mrays_per_s", timing.embreePacket16},
                    {"embree_stream_mrays_per_s", timing.embreeStream},
                    {"ratio", timing.singleToSingle.value},
                    {"ratio_interval", json(timing.singleToSingle)},
                    {"ratio_to_robust", json(timing.singleToRobust)},
                    {"batched_to_embree_single", json(timing.batchedToSingle)},
                    {"batched_to_embree_best", json(timing.batchedToBest)}});
    return row;
}

nlohmann::json json(const measure::PictureTiming& timing) {
    return {{"width", timing.size},
            {"height", timing.size},
            {"samples", timing.samples},
            {"rays", timing.rays},
            {"picture_mrays_per_s", timing.picture},
            {"queries_mrays_per_s", timing.queries},
            {"share", timing.share.value},
            {"share_interval", json(timing.share)}};
}

/// The value of a setting as text.
std::string settingText(const measure::BenchRow& row, std::string_view key) {
    Settings settings;
    settings.bvhBuilder = row.build.builder;
    settings.bvhLayout = row.build.layout;
    settings.isa = row.isa;
    return textOf(settings, key);
}

nlohmann::json json(const measure::BenchRow& row) {
    nlohmann::json rays = nlohmann::json::object();
    std::size_t different = 0;
    for (const measure::RayTiming& timing : row.rays) {
        rays[std::string(measure::benchNameOf(timing.kind))] = json(timing);
        different += timing.mismatches;
    }
    nlohmann::json result = {{"scene", row.scene},
                             {"triangles", row.triangles},
                             {"spheres", row.spheres},
                             {"threads", row.threads},
                             {"builder", settingText(row, "bvh_builder")},
                             {"layout", settingText(row, "bvh_layout")},
                             {"isa", settingText(row, "isa")},
                             {"build_ms", row.buildSeconds.value * 1e3},
                             {"build_seconds", json(row.buildSeconds)},
                             {"sah_cost", row.sahCost},
                             {"counted_cost", row.countedCost},
                             {"levels", row.summary.binaryLevels},
                             {"binary_nodes", row.summary.binaryNodes},
                             {"wide_nodes", row.summary.wideNodes},
                             {"triangles_per_leaf", row.blockFill},
                             {"bytes_per_triangle", row.bytesPerPrimitive},
                             {"rays", rays},
                             {"mismatches", different}};
    if (measure::EmbreeBaseline::isAvailable())
        result.update({{"embree_build_ms", row.embreeBuildSeconds.value * 1e3},
                       {"embree_bytes_per_triangle", row.embreeBytesPerPrimitive},
                       {"build_ratio", json(row.buildRatio)}});
    return result;
}

std::string ratio(const Interval& interval) {
    return fmt::format("{:5.2f} [{:.2f} {:.2f}]", interval.value, interval.lower, interval.upper);
}

void print(const measure::BenchRow& row) {
    base::print("{}: {} triangles, {} spheres, {} thread{}\n", base::printable(row.scene), row.triangles,
                row.spheres, row.threads, row.threads == 1 ? "" : "s");
    base::print("  {}: SAH cost {:.2f}, cost of random lines {:.2f}; {} levels, {} nodes",
                settingText(row, "bvh_builder"), row.sahCost, row.countedCost, row.summary.binaryLevels,
                row.summary.binaryNodes);
    if (row.summary.wideNodes > 0)
        base::print("; {} wide nodes, {:.1f} triangles per leaf", row.summary.wideNodes, row.blockFill);
    base::print("\n");
    base::print("  build {:.1f} ms, {:.1f} bytes per primitive", row.buildSeconds.value * 1e3,
                row.bytesPerPrimitive);
    if (measure::EmbreeBaseline::isAvailable())
        base::print("; Embree {:.1f} ms, {:.1f} bytes; {} times as fast", row.embreeBuildSeconds.value * 1e3,
                    row.embreeBytesPerPrimitive, ratio(row.buildRatio));
    base::print("\n  {:8} {:>8} {:>8}", "Mray/s", "single", "batched");
    if (measure::EmbreeBaseline::isAvailable())
        base::print(" | Embree {:>6} {:>6} {:>6} {:>6} | {:17} {:17} {:17} {:17} {}", "single", "robust",
                    "16-wide", "stream", "single/single", "single/robust", "batched/single", "batched/best",
                    "mismatches");
    base::print("\n");
    for (const measure::RayTiming& timing : row.rays) {
        base::print("  {:8} {:8.2f} {:8.2f}", measure::benchNameOf(timing.kind), timing.single,
                    timing.batched);
        if (measure::EmbreeBaseline::isAvailable())
            base::print(" |        {:6.2f} {:6.2f} {:6.2f} {:6.2f} | {} {} {} {} {}", timing.embreeSingle,
                        timing.embreeRobust, timing.embreePacket16, timing.embreeStream,
                        ratio(timing.singleToSingle), ratio(timing.singleToRobust),
                        ratio(timing.batchedToSingle), ratio(timing.batchedToBest), timing.mismatches);
        base::print("\n");
    }
    if (row.summary.wideNodes > 0)
        base::print("  {:8} {:>8} {:>8} {:>8} {:>8}\n", "per ray", "nodes", "leaves", "filter", "exact");
    for (const measure::RayTiming& timing : row.rays)
        if (timing.nodes > 0.0)
            base::print("  {:8} {:8.2f} {:8.2f} {:8.2f} {:8.2f}\n", measure::benchNameOf(timing.kind),
                        timing.nodes, timing.leaves, timing.primitives, timing.exact);
}

void print(const measure::PictureTiming& timing) {
    base::print("  {:8} {:>8} {:>8} {:>17}\n", "Mray/s", "whole", "its rays", "share of search");
    base::print("  {:8} {:8.2f} {:8.2f} {:>17}   {} × {}, {} samples, {} rays\n", "picture", timing.picture,
                timing.queries, ratio(timing.share), timing.size, timing.size, timing.samples, timing.rays);
}

/// The centre of the first light, or a point above the scene if there is none.
glm::vec3 lightOf(const SceneDescription& scene) {
    if (scene.lights.empty()) {
        const SceneBounds bounds = boundsOf(scene);
        return 0.5f * (bounds.lower + bounds.upper) +
               static_cast<float>(math::distance(bounds.lower, bounds.upper)) * glm::vec3(0.8f, 1.6f, 0.4f);
    }
    const auto& shape = scene.lights[0].shape;
    if (const auto* point = std::get_if<PointLight>(&shape)) return point->position;
    if (const auto* segment = std::get_if<SegmentLight>(&shape))
        return 0.5f * (segment->endpoints[0] + segment->endpoints[1]);
    const auto& area = std::get<ParallelogramLight>(shape);
    return area.corner + 0.5f * (area.edges[0] + area.edges[1]);
}

RenderRequest openBenchScene(const std::string& name, const BenchCommandOptions& options) {
    SceneOptions sceneOptions;
    sceneOptions.scene = name;
    sceneOptions.assignments = options.assignments;
    return openScene(sceneOptions, true, progressStyle("", false));
}

measure::BenchRow benchRays(const std::string& name, const RenderRequest& request,
                            const BenchCommandOptions& options) {
    const auto geometries = trace::makeGeometry(*request.scene, false);
    const AccelInput input = geometries.empty() ? AccelInput{} : geometries[0]->input;
    measure::BenchOptions bench;
    bench.build = trace::buildSettingsOf(request.settings);
    bench.threads = render::ThreadArena::countFor(options.threads);
    bench.size = options.size;
    bench.rounds = options.rounds;
    return measure::runBench(name, input, request.camera, lightOf(*request.scene), bench,
                             [](const std::string&) {});
}

int runBenchCommand(const BenchCommandOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    OutputFiles files;
    for (const std::string& scene : options.scenes) {
        const RenderRequest request = openBenchScene(scene, options);
        const measure::BenchRow row = benchRays(scene, request, options);
        print(row);
        base::flushOutput();
        const measure::PictureTiming picture = measure::timePicture(
            {.scene = request.scene, .settings = request.settings, .camera = request.camera}, options.size,
            options.threads, options.rounds);
        print(picture);
        base::flushOutput();
        rows.push_back(json(row));
        rows.back()["picture"] = json(picture);
        if (options.jsonFile.empty()) continue;
        // After each scene, so that an interrupt leaves what was measured.
        files.write(options.jsonFile,
                    [&] { base::writeFileAtomically(options.jsonFile, base::jsonText(rows)); });
    }
    return files.exitCode(kSuccess);
}

}  // namespace

std::function<int()> setUpBench(OptionList& list) {
    auto options = std::make_shared<BenchCommandOptions>();
    options->scenes = {"builtin:cornell", "builtin:monkey", "builtin:teapot"};
    list.add("scenes", &options->scenes,
             fmt::format("Scenes: {} or builtin:NAME", fmt::join(sceneFileSuffixes(), ", ")))
        .suggest(builtinSceneNames);
    list.add("--json", &options->jsonFile, "Write all figures to this file").writes(Option::Output::File);
    addThreadsTo(list, options->threads);
    addSettingsTo(list, options->assignments);
    list.add("--size", &options->size, "Width and height of the image of primary rays")
        .from(8, 16384)
        .showDefault();
    list.add("--rounds", &options->rounds, "Rounds of interleaved measurements").from(5, 1000).showDefault();
    return [options] { return runBenchCommand(*options); };
}

}  // namespace rayscope::cli
