// The cost of the sign-exact triangle test: the AVX2 kernels against the same traversal with the test of
// Möller and Trumbore.
//
//   triangle_cost                      interleaved timings; prints the median of the ratios
//   triangle_cost exact|plain|none N   traces N incoherent rays with one of them, to count instructions
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "bench/bench_scene.h"
#include "bench/plain/plain_kernels.h"
#include "bvh/builders/build.h"
#include "bvh/isa.h"
#include "bvh/layout/wide_tree.h"

namespace rayscope::bench {
namespace {

constexpr int kTriangles = 100000;

/// Independent random rays from around the mesh.
std::vector<Ray> incoherentRays(std::size_t count) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    const auto point = [&] { return glm::dvec3(real(random), real(random), real(random)); };
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = glm::vec3(1.5 * point());
        ray.direction = glm::vec3(glm::normalize(0.7 * point() - glm::dvec3(ray.origin)));
    }
    return rays;
}

struct Comparison {
    BumpySphere mesh{kTriangles};
    bvh::BinaryTree binary = bvh::buildBinaryTree(mesh.input(), {});
    bvh::WideTree tree = bvh::collapse(binary, mesh.input(), {});

    /// Returns seconds.
    double run(const bvh::kernel::Kernels& kernels, const std::vector<Ray>& rays,
               std::vector<Hit>& hits) const {
        const auto start = std::chrono::steady_clock::now();
        kernels.closestHits(tree.view(), reinterpret_cast<const float*>(rays.data()),
                            reinterpret_cast<bvh::kernel::HitData*>(hits.data()), rays.size());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
};

void compare(const Comparison& comparison) {
    const std::vector<Ray> rays = incoherentRays(200000);
    std::vector<Hit> exact(rays.size()), plain(rays.size());
    std::vector<double> ratios;
    for (int i = 0; i < 15; ++i) {
        const bool exactFirst = i % 2 == 0;
        const double first = comparison.run(exactFirst ? bvh::kernelsFor(Isa::Avx2) : kPlainKernels, rays,
                                            exactFirst ? exact : plain);
        const double second = comparison.run(exactFirst ? kPlainKernels : bvh::kernelsFor(Isa::Avx2), rays,
                                             exactFirst ? plain : exact);
        ratios.push_back(exactFirst ? first / second : second / first);
    }
    std::sort(ratios.begin(), ratios.end());
    std::size_t hits = 0, differ = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits += exact[i].primitive != kNoPrimitive;
        differ += exact[i].primitive != plain[i].primitive;
    }
    fmt::print(
        "{} triangles, {} rays, {} hits, {} with different primitives\nexact / plain: {:.3f} (quartiles "
        "{:.3f} … "
        "{:.3f})\n",
        kTriangles, rays.size(), hits, differ, ratios[7], ratios[3], ratios[11]);
}

}  // namespace
}  // namespace rayscope::bench

int main(int argc, char** argv) {
    using namespace rayscope;
    using namespace rayscope::bench;
    if (!bvh::isAvailable(Isa::Avx2)) return fmt::print("needs AVX2\n"), 77;
    const Comparison comparison;
    if (argc < 3) return compare(comparison), 0;
    const std::vector<Ray> rays = incoherentRays(std::strtoull(argv[2], nullptr, 10));
    std::vector<Hit> hits(rays.size());
    if (std::strcmp(argv[1], "none") == 0) return 0;
    comparison.run(std::strcmp(argv[1], "plain") == 0 ? kPlainKernels : bvh::kernelsFor(Isa::Avx2), rays,
                   hits);
    return 0;
}
