// Searches the same rays again and again, each kind and each kind of query between the same two gates, so
// that callgrind can say what a ray costs in instructions. usage: count_rays ISA        prints what was
// counted, in order
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

/// The kernels that a name of the setting `isa` chooses. Throws InputError for any other.
Isa isaOf(const char* name) {
    Settings settings;
    assign(settings, "isa", name);
    return settings.isa;
}

struct Answers {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> occluded;
};

}  // namespace

// The gates: callgrind knows them by name.
extern "C" {
[[gnu::noipa]] void countedSingle(const Accel& accel, std::span<const Ray> rays, bool any, Answers& answers) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (any)
            answers.occluded[i] = accel.anyHit(rays[i]);
        else
            accel.closestHit(rays[i], answers.hits[i]);
    }
}

[[gnu::noipa]] void countedBatched(const Accel& accel, std::span<const Ray> rays, bool any,
                                   Answers& answers) {
    if (any)
        accel.anyHits(rays, answers.occluded);
    else
        accel.closestHits(rays, answers.hits);
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
        Answers answers{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size())};
        // The first time pays for what is set up once.
        countedSingle(accel, std::span(rays).first(1), any, answers);
        countedSingle(accel, rays, any, answers);
        countedBatched(accel, rays, any, answers);
        fmt::print("{0} single {1}\n{0} batched {1}\n", measure::benchNameOf(kind), rays.size());
    }
} catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
}
