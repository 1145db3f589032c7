#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>

#include "base/atomic_file.h"
#include "base/console.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interrupt_stop_source.h"
#include "cli/ray_file.h"
#include "cli/scene_options.h"
#include "render/cast_rays.h"
#include "render/thread_arena.h"
#include "trace/compile.h"

namespace rayscope::cli {

namespace {

// The records of the file have the memory layout of the struct.
static_assert(sizeof(Hit) == 16 && offsetof(Hit, primitive) == 4 && offsetof(Hit, u) == 8);
static_assert(std::endian::native == std::endian::little, "files of hits are little-endian");

struct CastOptions {
    SceneOptions scene;
    std::string rays, output;
    bool any = false, all = false, quiet = false;
};

struct CastCounts {
    std::uint64_t rays = 0, hits = 0;
    double seconds = 0.0;  ///< of the queries alone
};

std::string_view bytesOf(const auto& records) {
    const auto bytes = std::as_bytes(std::span(records));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Adds the seconds of its lifetime to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& seconds) : seconds_(seconds) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Each traces one step of rays, appends the results to the file and returns the number of hits.

std::uint64_t castClosest(const trace::World& world, std::span<const Ray> rays, base::AtomicFile& output,
                          double& seconds) {
    std::vector<Hit> hits(rays.size());
    {
        const Stopwatch stopwatch(seconds);
        render::castClosest(world, rays, hits);
    }
    output.write(bytesOf(hits));
    return static_cast<std::uint64_t>(
        std::ranges::count_if(hits, [](const Hit& hit) { return hit.primitive != kNoPrimitive; }));
}

std::uint64_t castAny(const trace::World& world, std::span<const Ray> rays, base::AtomicFile& output,
                      double& seconds) {
    std::vector<std::uint8_t> occluded(rays.size());
    {
        const Stopwatch stopwatch(seconds);
        render::castAny(world, rays, occluded);
    }
    output.write(bytesOf(occluded));
    return static_cast<std::uint64_t>(std::ranges::count(occluded, 1));
}

std::uint64_t castAll(const trace::World& world, std::span<const Ray> rays, base::AtomicFile& output,
                      double& seconds) {
    std::vector<std::vector<Hit>> hitsOfRays;
    {
        const Stopwatch stopwatch(seconds);
        hitsOfRays = render::castAll(world, rays);
    }
    std::uint64_t total = 0;
    for (const std::vector<Hit>& hits : hitsOfRays) {
        output.write(bytesOf(std::array{static_cast<std::uint32_t>(hits.size())}));
        output.write(bytesOf(hits));
        total += hits.size();
    }
    return total;
}

/// Rays of the next step with --all, such that its hits take about as much memory as those of a step
/// without, if they have as many hits as the rays so far.
std::size_t raysOfNextStep(const CastCounts& counts) {
    if (counts.rays == 0) return 1024;
    const double hitsPerRay = static_cast<double>(counts.hits) / static_cast<double>(counts.rays);
    return static_cast<std::size_t>(
        std::max(1.0, static_cast<double>(RayFile::kRaysPerStep) / (2.0 + hitsPerRay)));
}

int runCast(const CastOptions& options) {
    if (options.any && options.all) throw UsageError("--all", "cannot be combined with --any; choose one");
    const InterruptStopSource interrupt;
    RayFile file(options.rays);
    base::AtomicFile output(options.output);
    RenderRequest request = openScene(options.scene, options.quiet, progressStyle("", options.quiet));
    // All primitives at shutter open: one motion group, whose primitives are numbered triangles first.
    request.settings.motionBlur = false;
    render::ThreadArena arena(options.scene.threads);
    CastCounts counts;
    arena.run([&] {
        const auto world = trace::compile({request.scene, request.settings, request.camera, 1, 1}, nullptr,
                                          interrupt.token());
        std::vector<Ray> rays;
        const auto cast = options.all ? castAll : options.any ? castAny : castClosest;
        while (!interrupt.interrupted() &&
               file.next(rays, options.all ? raysOfNextStep(counts) : RayFile::kRaysPerStep)) {
            counts.hits += cast(*world, rays, output, counts.seconds);
            counts.rays += rays.size();
        }
    });
    if (interrupt.interrupted()) return kInterrupted;
    output.commit();
    if (!options.quiet)
        base::printMessage(
            "{} rays, {} {}, {:.2f} Mray/s\n", counts.rays, counts.hits, options.any ? "occluded" : "hits",
            counts.seconds > 0.0 ? static_cast<double>(counts.rays) * 1e-6 / counts.seconds : 0.0);
    return kSuccess;
}

}  // namespace

std::function<int()> setUpCast(OptionList& list) {
    auto options = std::make_shared<CastOptions>();
    options->scene.addSceneTo(list, true);
    list.add("--rays", &options->rays, "Ray file to read, of any length").form("FILE").reads().required();
    list.add("-o,--output", &options->output, "File of results to write, in the order of the rays")
        .required()
        .writes(Option::Output::File);
    list.add("--any", &options->any, "Any-hit queries: whether there is a hit, not the closest one");
    list.add("--all", &options->all, "All hits of each ray in order of t, not the closest one");
    list.add("-q,--quiet", &options->quiet, "Print errors only");
    list.setDetails(
        "A ray is 32 bytes, 8 little-endian float32: origin xyz, direction xyz, tMin, tMax. A result is 16 "
        "bytes: float32 t, uint32 primitive (triangles first, then spheres; 4294967295 for a miss), float32 "
        "u, v; with --any it is one byte, 1 if a primitive is hit in (tMin, tMax], else 0; with --all it is "
        "a "
        "uint32 count and as many results of 16 bytes. A negative tMin counts as 0.");
    return [options] { return runCast(*options); };
}

}  // namespace rayscope::cli
