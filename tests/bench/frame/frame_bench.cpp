// Renders frames with Rayscope and with a small renderer around Embree, in turn, on the same scenes. Prints
// the rows of docs/performance.md as JSON.
//
// usage: frame_bench THREADS SIZE SCENE…    with point lights, meshes and no textures
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

#include <rayscope/diagnostics.h>
#include "bench/frame/embree_frame.h"
#include "measure/statistics/statistics.h"
#include "render/render_pass.h"
#include "render/thread_arena.h"
#include "trace/compile.h"

namespace {

using namespace rayscope;

constexpr int kSamples = 4, kRounds = 9;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

nlohmann::json json(const Interval& interval) {
    return {{"median", interval.value}, {"low", interval.lower}, {"high", interval.upper}};
}

nlohmann::json compareFrames(const char* name, int size) {
    Diagnostics notes;
    trace::CompileRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene(name, notes));
    request.camera = request.scene->cameras.front();
    request.settings.spp = kSamples;
    request.width = request.height = size;
    request.keepBinaryTrees = false;
    const auto world = trace::compile(request);
    for (const trace::CompiledLight& light : world->lights)
        if (light.dimensions != 0) throw std::invalid_argument(fmt::format("{}: not a point light", name));
    const bench::EmbreeFrame embree(*world, request.camera);
    std::vector<glm::vec3> image(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    std::vector<double> own, other, ratio;
    std::uint64_t rays = 0, otherRays = 0;
    RgbImage mean;
    for (int round = 0; round < kRounds; ++round) {
        auto start = std::chrono::steady_clock::now();
        render::Film film(size, size, {0, size, 0, size});
        render::RenderCounters counters;
        render::renderPass(*world, 0, film, kSamples, {}, counters);
        own.push_back(secondsSince(start));
        start = std::chrono::steady_clock::now();
        otherRays = embree.render(kSamples, image);
        other.push_back(secondsSince(start));
        ratio.push_back(other.back() / own.back());
        mean = film.mean();
        rays = counters.rays;
    }
    glm::dvec3 difference(0.0);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            difference +=
                glm::dvec3(mean.at(x, y)) - glm::dvec3(image[static_cast<std::size_t>(y * size + x)]);
    difference = glm::abs(difference) / (static_cast<double>(size) * size);
    return {{"scene", name},
            {"size", size},
            {"samples", kSamples},
            {"rays", rays},
            {"embree_rays", otherRays},
            {"seconds", measure::medianInterval(own).value},
            {"embree_seconds", measure::medianInterval(other).value},
            {"ratio", json(measure::medianInterval(ratio))},
            {"mean_difference", std::max(difference.x, std::max(difference.y, difference.z))}};
}

}  // namespace

int main(int count, char** arguments) try {
    if (count < 4) throw std::invalid_argument("usage: frame_bench THREADS SIZE SCENE…");
    const int threads = std::stoi(arguments[1]), size = std::stoi(arguments[2]);
    nlohmann::json rows = nlohmann::json::array();
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
    render::ThreadArena arena(threads);
    for (int i = 3; i < count; ++i) {
        rows.push_back(arena.run([&] { return compareFrames(arguments[i], size); }));
        rows.back()["threads"] = threads;
    }
    std::cout << rows.dump(1) << '\n';
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
