#include "measure/bench/picture_bench.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "measure/bench/picture_rays.h"
#include "measure/statistics/statistics.h"
#include "render/render_pass.h"
#include "render/thread_arena.h"

namespace rayscope::measure {
namespace {

constexpr int kSamples = 4, kProbeSize = 32;
constexpr double kMostRays = 0x1p22;  ///< 32 bytes each, and 16 of its hit
constexpr std::size_t kRaysPerTask = 16384;
constexpr std::uint64_t kSeed = 0;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Returns the number of rays.
std::uint64_t renderPicture(const trace::World& world) {
    render::Film film(world.width, world.height, {0, world.width, 0, world.height});
    render::RenderCounters counters;
    render::renderPass(world, kSeed, film, kSamples, {}, counters);
    return counters.rays;
}

/// The samples of the picture in the order of its tiles.
std::vector<SampleId> samplesOf(const trace::World& world) {
    const render::Film film(world.width, world.height, {0, world.width, 0, world.height});
    std::vector<SampleId> samples;
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        const PixelBounds bounds = film.tileBounds(tile);
        for (int y = bounds.y0; y < bounds.y1; ++y)
            for (int x = bounds.x0; x < bounds.x1; ++x)
                for (int index = 0; index < kSamples; ++index) samples.push_back({x, y, index});
    }
    return samples;
}

template <class Work>
void inChunks(std::size_t size, const Work& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, size, kRaysPerTask),
        [&](const auto& chunk) { work(chunk.begin(), chunk.size()); }, tbb::simple_partitioner{});
}

/// The queries of a picture. In a world that moves rays are traced one by one, as the picture does.
class PictureQueries {
  public:
    PictureQueries(const trace::World& world, PictureRays rays)
        : world_(world),
          rays_(std::move(rays)),
          hits_(rays_.closest.rays.size()),
          occluded_(rays_.any.rays.size()) {}

    void trace() {
        inChunks(hits_.size(), [&](std::size_t first, std::size_t count) {
            if (!world_.moves)
                return world_.closestHits(std::span(rays_.closest.rays).subspan(first, count), 0.0f,
                                          std::span(hits_).subspan(first, count));
            for (std::size_t i = first; i < first + count; ++i)
                world_.closestHit(rays_.closest.rays[i], rays_.closest.times[i], hits_[i]);
        });
        inChunks(occluded_.size(), [&](std::size_t first, std::size_t count) {
            if (!world_.moves)
                return world_.anyHits(std::span(rays_.any.rays).subspan(first, count), 0.0f,
                                      std::span(occluded_).subspan(first, count));
            for (std::size_t i = first; i < first + count; ++i)
                occluded_[i] = world_.anyHit(rays_.any.rays[i], rays_.any.times[i]);
        });
    }

  private:
    const trace::World& world_;
    PictureRays rays_;
    base::BigVector<Hit> hits_;
    std::vector<std::uint8_t> occluded_;
};

std::shared_ptr<const trace::World> worldOf(trace::CompileRequest& request, int size,
                                            const trace::World* previous) {
    request.width = request.height = size;
    return trace::compile(request, previous);
}

}  // namespace

PictureTiming timePicture(trace::CompileRequest request, int size, int threads, int rounds) {
    render::ThreadArena arena(threads);
    return arena.run([&] {
        request.settings.spp = kSamples;
        request.keepBinaryTrees = false;
        const auto probe = worldOf(request, std::min(size, kProbeSize), nullptr);
        const double perPixel = static_cast<double>(renderPicture(*probe)) / (probe->width * probe->height);
        PictureTiming timing;
        timing.samples = kSamples;
        timing.size = std::clamp(static_cast<int>(std::sqrt(kMostRays / perPixel)), 1, size);
        const auto world = worldOf(request, timing.size, probe.get());
        PictureRays rays = recordRays(*world, kSeed, samplesOf(*world));
        timing.rays = rays.size();
        PictureQueries queries(*world, std::move(rays));
        std::vector<double> picture, search, share;
        for (int round = 0; round < rounds; ++round) {
            auto start = std::chrono::steady_clock::now();
            renderPicture(*world);
            picture.push_back(secondsSince(start));
            start = std::chrono::steady_clock::now();
            queries.trace();
            search.push_back(secondsSince(start));
            share.push_back(search.back() / picture.back());
        }
        const double millions = static_cast<double>(timing.rays) * 1e-6;
        timing.picture = millions / medianInterval(picture).value;
        timing.queries = millions / medianInterval(search).value;
        timing.share = medianInterval(share);
        return timing;
    });
}

}  // namespace rayscope::measure
