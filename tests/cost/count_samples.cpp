// Traces the same samples one by one, in batches and as a frame, in three functions whose instructions
// callgrind counts. Prints the number of samples for each scene.
//
// usage: count_samples SCENE…
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <vector>

#include <rayscope/diagnostics.h>
#include <rayscope/scene.h>
#include "render/render_tile.h"
#include "trace/compile.h"
#include "trace/radiance.h"
#include "trace/radiance_batch.h"

namespace {

using namespace rayscope;

constexpr int kSize = 32;

std::shared_ptr<const trace::World> worldOf(const char* scene) {
    Diagnostics notes;
    trace::CompileRequest request;
    request.scene = std::make_shared<const SceneDescription>(loadScene(scene, notes));
    request.camera = request.scene->cameras.front();
    request.settings.spp = 1;
    request.settings.glossy = true;
    request.settings.isa = Isa::Sse2;
    request.width = request.height = kSize;
    return trace::compile(request);
}

}  // namespace

// instructions.py selects these functions by name.
extern "C" {
[[gnu::noipa]] void countedSingle(const trace::World& world, std::span<const SampleId> samples,
                                  std::vector<RgbSum>& radiance) {
    trace::NullObserver observer;
    for (const SampleId& sample : samples)
        radiance.push_back(trace::radiance(world, 1, sample, observer).radiance);
}

[[gnu::noipa]] void countedBatched(const trace::World& world, std::span<const SampleId> samples,
                                   std::vector<RgbSum>& radiance) {
    const std::stop_token never;
    trace::RadianceBatch batch(world, 1, never);
    for (std::size_t first = 0; first < samples.size(); first += trace::RadianceBatch::kSize) {
        batch.start(samples.subspan(first, trace::RadianceBatch::kSize));
        while (batch.next()) batch.trace();
        for (const trace::SampleResult& result : batch.finish()) radiance.push_back(result.radiance);
    }
}

[[gnu::noipa]] void countedFrame(const trace::World& world, render::Film& film) {
    render::RenderCounters counters;
    for (int tile = 0; tile < film.tileCount(); ++tile)
        render::renderTile(world, 1, film, tile, 1, {}, counters);
}
}

int main(int count, char** arguments) try {
    std::vector<SampleId> samples;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) samples.push_back({x, y, 0});
    for (int i = 1; i < count; ++i) {
        const std::shared_ptr<const trace::World> world = worldOf(arguments[i]);
        // The first round includes lazy initialisation.
        for (int round = 0; round < 2; ++round) {
            std::vector<RgbSum> single, batched;
            single.reserve(samples.size());
            batched.reserve(samples.size());
            countedSingle(*world, samples, single);
            countedBatched(*world, samples, batched);
            render::Film film(kSize, kSize, {0, kSize, 0, kSize});
            countedFrame(*world, film);
            if (single != batched)
                throw std::runtime_error(
                    fmt::format("{}: radiance() and RadianceBatch differ", arguments[i]));
        }
        fmt::print("{} {}\n", arguments[i], samples.size());
    }
} catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
}
