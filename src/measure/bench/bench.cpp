#include "measure/bench/bench.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "bvh/binary_tree.h"
#include "bvh/builders/build.h"
#include "bvh/layout/statistics.h"
#include "bvh/traversal/traversal_counts.h"
#include "measure/bench/embree_baseline.h"
#include "measure/bench/random_lines.h"
#include "measure/statistics/statistics.h"

namespace rayscope::measure {
namespace {

constexpr std::size_t kChunk = 16384;

Interval intervalOf(const std::vector<double>& values) {
    return values.empty() ? Interval{} : medianInterval(values);
}

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Times queries of a fixed set of rays, with Rayscope or with Embree.
class RayTimer {
  public:
    RayTimer(std::span<const Ray> rays, bool any, int threads)
        : rays_(rays.begin(), rays.end()),
          hits_(rays_.size()),
          occluded_(rays_.size()),
          any_(any),
          threads_(threads) {}

    std::size_t size() const { return rays_.size(); }
    std::span<const Ray> rays() const { return rays_; }
    std::size_t countHits() const {
        return any_ ? static_cast<std::size_t>(std::ranges::count(occluded_, 1))
                    : static_cast<std::size_t>(std::ranges::count_if(
                          hits_, [](const Hit& hit) { return hit.primitive != kNoPrimitive; }));
    }
    /// For each ray, whether the last query found a hit.
    std::vector<bool> hitMask() const {
        std::vector<bool> result(size());
        for (std::size_t i = 0; i < size(); ++i)
            result[i] = any_ ? occluded_[i] != 0 : hits_[i].primitive != kNoPrimitive;
        return result;
    }

    double single(const Accel& accel) {
        return timed([&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (any_)
                    occluded_[i] = accel.anyHit(rays_[i]);
                else
                    accel.closestHit(rays_[i], hits_[i]);
            }
        });
    }
    double batched(const Accel& accel) {
        return timed([&](std::size_t begin, std::size_t end) {
            const auto rays = std::span<const Ray>(rays_).subspan(begin, end - begin);
            if (any_)
                accel.anyHits(rays, std::span(occluded_).subspan(begin, end - begin));
            else
                accel.closestHits(rays, std::span(hits_).subspan(begin, end - begin));
        });
    }
    double embree(const EmbreeBaseline& embree, EmbreeQuery query, bool coherent) {
        return timed([&](std::size_t begin, std::size_t end) {
            const auto rays = std::span<const Ray>(rays_).subspan(begin, end - begin);
            if (any_)
                embree.anyHits(query, coherent, rays, std::span(occluded_).subspan(begin, end - begin));
            else
                embree.closestHits(query, coherent, rays, std::span(hits_).subspan(begin, end - begin));
        });
    }

  private:
    template <class Work>
    double timed(const Work& work) const {
        return secondsOf([&] {
            if (threads_ == 1) return work(0, size());
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, size(), kChunk),
                [&](const auto& block) { work(block.begin(), block.end()); }, tbb::simple_partitioner{});
        });
    }

    base::BigVector<Ray> rays_;
    base::BigVector<Hit> hits_;
    std::vector<std::uint8_t> occluded_;
    bool any_;
    int threads_;
};

struct Accels {
    const Accel& own;
    const EmbreeBaseline* fast;
    const EmbreeBaseline* robust;
};

RayTiming timeRays(const Accels& accels, BenchRayKind kind, RayTimer& timer, int rounds) {
    RayTiming timing;
    timing.kind = kind;
    timing.rays = timer.size();
    const bool coherent = kind != BenchRayKind::Bounce && kind != BenchRayKind::AmbientOcclusion;
    std::vector<double> single, batched, fast, robust, packet, stream;
    std::vector<double> toSingle, toRobust, batchToSingle, batchToBest, batchToOwn;
    for (int round = 0; round < rounds; ++round) {
        single.push_back(timer.single(accels.own));
        const std::vector<bool> ownMask = round == 0 ? timer.hitMask() : std::vector<bool>{};
        if (round == 0) timing.hits = timer.countHits();
        batched.push_back(timer.batched(accels.own));
        batchToOwn.push_back(single.back() / batched.back());
        if (!accels.fast) continue;
        robust.push_back(timer.embree(*accels.robust, EmbreeQuery::Single, coherent));
        if (round == 0) {
            const std::vector<bool> mask = timer.hitMask();
            for (std::size_t i = 0; i < mask.size(); ++i) timing.mismatches += mask[i] != ownMask[i];
        }
        fast.push_back(timer.embree(*accels.fast, EmbreeQuery::Single, coherent));
        packet.push_back(timer.embree(*accels.fast, EmbreeQuery::Packet16, coherent));
        stream.push_back(timer.embree(*accels.fast, EmbreeQuery::Stream, coherent));
        toSingle.push_back(fast.back() / single.back());
        toRobust.push_back(robust.back() / single.back());
        batchToSingle.push_back(fast.back() / batched.back());
        batchToBest.push_back(std::min({fast.back(), packet.back(), stream.back()}) / batched.back());
    }
    const auto speed = [&](const std::vector<double>& seconds) {
        return seconds.empty() ? 0.0
                               : static_cast<double>(timer.size()) * 1e-6 / medianInterval(seconds).value;
    };
    timing.single = speed(single);
    timing.batched = speed(batched);
    timing.embreeSingle = speed(fast);
    timing.embreeRobust = speed(robust);
    timing.embreePacket16 = speed(packet);
    timing.embreeStream = speed(stream);
    timing.singleToSingle = intervalOf(toSingle);
    timing.singleToRobust = intervalOf(toRobust);
    timing.batchedToSingle = intervalOf(batchToSingle);
    timing.batchedToBest = intervalOf(batchToBest);
    timing.batchedToOwnSingle = intervalOf(batchToOwn);
    return timing;
}

void setCounts(RayTiming& timing, const bvh::TraversalCounts& counts) {
    const auto perRay = [&](std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(timing.rays);
    };
    timing.nodes = perRay(counts.nodes);
    timing.leaves = perRay(counts.leaves);
    timing.primitives = perRay(counts.primitives);
    timing.exact = perRay(counts.exact);
}

void describeTree(BenchRow& row, const Accel& accel, const AccelInput& input, const BuildSettings& settings) {
    constexpr int kLines = 10000;
    row.summary = accel.summary();
    if (row.summary.triangleBlocks > 0)
        row.blockFill = static_cast<double>(row.triangles) / static_cast<double>(row.summary.triangleBlocks);
    BuildSettings withBinaryTree = settings;
    withBinaryTree.keepBinaryTree = true;
    const bvh::BinaryTree tree = bvh::buildBinaryTree(input, withBinaryTree);
    row.sahCost = bvh::statisticsOf(tree).sahCost;
    row.countedCost = costOfRandomLines(tree, kLines);
}

}  // namespace

BenchRow runBench(const std::string& name, const AccelInput& input, const CameraDescription& camera,
                  const glm::vec3& light, const BenchOptions& options,
                  const std::function<void(const std::string&)>& progress) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
    BenchRow row;
    row.scene = name;
    row.triangles = input.triangles.size();
    row.spheres = input.spheres.size();
    row.threads = options.threads;
    row.build = options.build;
    progress("build");
    std::vector<double> build, embreeBuild, ratio;
    Accel accel;
    std::optional<EmbreeBaseline> fast, robust;
    for (int round = 0; round < std::max(5, options.rounds); ++round) {
        build.push_back(secondsOf([&] { accel = Accel::build(input, options.build); }));
        if (!EmbreeBaseline::isAvailable()) continue;
        fast.emplace(input, false, options.threads);
        embreeBuild.push_back(fast->buildSeconds());
        ratio.push_back(embreeBuild.back() / build.back());
    }
    if (EmbreeBaseline::isAvailable()) robust.emplace(input, true, options.threads);
    row.buildSeconds = intervalOf(build);
    row.embreeBuildSeconds = intervalOf(embreeBuild);
    row.buildRatio = intervalOf(ratio);
    const auto primitives = static_cast<double>(std::max<std::size_t>(1, row.triangles + row.spheres));
    row.bytesPerPrimitive = static_cast<double>(accel.bytes()) / primitives;
    if (fast) row.embreeBytesPerPrimitive = static_cast<double>(fast->bytes()) / primitives;
    row.isa = accel.summary().isa;
    describeTree(row, accel, input, options.build);
    for (const BenchRayKind kind : kBenchRayKinds) {
        progress(std::string(benchNameOf(kind)));
        RayTimer timer(makeBenchRays(accel, camera, light, kind, options.size), isAnyHitKind(kind),
                       options.threads);
        if (timer.size() == 0) continue;
        row.rays.push_back(timeRays({accel, fast ? &*fast : nullptr, robust ? &*robust : nullptr}, kind,
                                    timer, options.rounds));
        if (accel.wideTree())
            setCounts(row.rays.back(),
                      bvh::countTraversals(*accel.wideTree(), timer.rays(), isAnyHitKind(kind)));
    }
    return row;
}

}  // namespace rayscope::measure
