// Rays per second beside Embree, where it is installed: every repetition traces the same rays with both in
// turn, so that the ratio means something on a machine that is not quiet.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

#include "bench/bench_scene.h"
#ifdef RAYSCOPE_HAS_EMBREE
#include "bench/embree_scene.h"
#endif

namespace rayscope::bench {
namespace {

constexpr int kRepetitions = 11;

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

bool wantsAnyHit(RayKind kind) { return kind == RayKind::Shadow || kind == RayKind::AmbientOcclusion; }

void trace(const Accel& accel, const std::vector<Ray>& rays, bool any) {
    Hit hit;
    for (const Ray& ray : rays) {
        if (any) {
            accel.anyHit(ray);
        } else {
            accel.closestHit(ray, hit);
        }
    }
}

void compare(int triangles, int resolution) {
    const BumpySphere mesh(triangles);
    const Accel accel = Accel::build(mesh.input());
#ifdef RAYSCOPE_HAS_EMBREE
    const EmbreeScene fast(mesh, false), robust(mesh, true);
#endif
    fmt::print("{} triangles, {:.1f} bytes each; Mray/s on one thread, medians of {} interleaved runs\n",
               mesh.triangles.size(),
               static_cast<double>(accel.bytes()) / static_cast<double>(mesh.triangles.size()), kRepetitions);
    for (const RayKind kind : kRayKinds) {
        const std::vector<Ray> rays = makeRays(accel, kind, resolution);
        const bool any = wantsAnyHit(kind);
        const double million = static_cast<double>(rays.size()) * 1e-6;
        std::vector<double> own, toFast, toRobust;
        for (int i = 0; i < kRepetitions; ++i) {
            own.push_back(seconds([&] { trace(accel, rays, any); }));
#ifdef RAYSCOPE_HAS_EMBREE
            toFast.push_back(seconds([&] { fast.trace(rays, any); }) / own.back());
            toRobust.push_back(seconds([&] { robust.trace(rays, any); }) / own.back());
#endif
        }
        fmt::print("  {:8} {:6.2f}", nameOf(kind), million / median(own));
        if (!toFast.empty())
            fmt::print("   {:.2f} × Embree, {:.2f} × Embree robust", median(toFast), median(toRobust));
        fmt::print("\n");
    }
}

}  // namespace
}  // namespace rayscope::bench

int main(int argc, char** argv) {
    const std::vector<int> sizes =
        argc > 1 ? std::vector<int>{std::atoi(argv[1])} : std::vector<int>{1000, 87130, 1000000};
    for (const int triangles : sizes) rayscope::bench::compare(triangles, 512);
}
