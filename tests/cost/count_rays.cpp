// Traces the same rays repeatedly in two functions, for single and batched queries, whose instructions
// callgrind counts. Prints the kinds of rays and queries with their numbers of rays, in the order of the
// calls.
//
// usage: count_rays ISA
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include <rayscope/settings.h>
#include "bench/bench_scene.h"
#include "measure/bench/bench_rays.h"

namespace {

using namespace rayscope;

/// The value of the setting `isa` with this name. Throws InputError for any other.
Isa isaOf(const char* name) {
    Settings settings;
    assign(settings, "isa", name);
    return settings.isa;
}

struct Results {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> occluded;
};

}  // namespace

// instructions.py selects these functions by name.
extern "C" {
[[gnu::noipa]] void countedSingle(const Accel& accel, std::span<const Ray> rays, bool any, Results& results) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (any)
            results.occluded[i] = accel.anyHit(rays[i]);
        else
            accel.closestHit(rays[i], results.hits[i]);
    }
}

[[gnu::noipa]] void countedBatched(const Accel& accel, std::span<const Ray> rays, bool any,
                                   Results& results) {
    if (any)
        accel.anyHits(rays, results.occluded);
    else
        accel.closestHits(rays, results.hits);
}
}

int main(int count, char** arguments) try {
    if (count != 2) return 1;
    const bench::BumpySphere scene(20000);
    BuildSettings build;
    build.isa = isaOf(arguments[1]);
    const Accel accel = Accel::build(scene.input(), build);
    CameraDescription camera;
    camera.lookFrom = {1.5f, 1.0f, 2.0f};
    for (const measure::BenchRayKind kind : measure::kBenchRayKinds) {
        const std::vector<Ray> rays = measure::makeBenchRays(accel, camera, {2.0f, 4.0f, 3.0f}, kind, 64);
        const bool any = measure::isAnyHitKind(kind);
        Results results{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size())};
        // The first call includes initialisation.
        countedSingle(accel, std::span(rays).first(1), any, results);
        countedSingle(accel, rays, any, results);
        countedBatched(accel, rays, any, results);
        fmt::print("{0} single {1}\n{0} batched {1}\n", measure::benchNameOf(kind), rays.size());
    }
} catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
}
