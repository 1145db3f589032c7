// Build times: build/<builder>/<triangles>/<threads>.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <map>

#include "bench/bench_scene.h"
#include "bvh/builders/build.h"
#include "bvh/layout/statistics.h"

namespace rayscope::bench {
namespace {

const BumpySphere& sphere(int triangles) {
    static std::map<int, BumpySphere> known;
    return known.try_emplace(triangles, triangles).first->second;
}

void build(benchmark::State& state, BvhBuilder builder) {
    const BumpySphere& mesh = sphere(static_cast<int>(state.range(0)));
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(1)));
    BuildSettings settings;
    settings.builder = builder;
    Accel accel;
    for (auto _ : state) accel = Accel::build(mesh.input(), settings);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const bvh::TreeStatistics statistics = bvh::statisticsOf(bvh::buildBinaryTree(mesh.input(), settings));
    state.counters["bytes/tri"] = static_cast<double>(accel.bytes()) / triangles;
    state.counters["sah"] = statistics.sahCost;
    state.counters["levels"] = statistics.levels;
    state.counters["Mtri/s"] = benchmark::Counter(triangles * 1e-6 * static_cast<double>(state.iterations()),
                                                  benchmark::Counter::kIsRate);
}

void sizes(benchmark::internal::Benchmark* bench) {
    for (const int triangles : {1000, 15704, 87130, 1000000, 10000000})
        for (const int threads : {1, 2}) bench->Args({triangles, threads});
    bench->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_CAPTURE(build, median, BvhBuilder::Median)->Apply(sizes);
BENCHMARK_CAPTURE(build, sah, BvhBuilder::Sah)->Apply(sizes);
BENCHMARK_CAPTURE(build, sah_binned, BvhBuilder::SahBinned)->Apply(sizes);
BENCHMARK_CAPTURE(build, high, BvhBuilder::SahReinsertion)->Apply(sizes);

}  // namespace
}  // namespace rayscope::bench
