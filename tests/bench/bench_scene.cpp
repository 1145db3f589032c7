#include "bench/bench_scene.h"

#include <cmath>
#include <numbers>

namespace rayscope::bench {
namespace {

glm::vec3 bumpyPoint(double theta, double phi) {
    const double bump = 0.1 * std::sin(5 * phi) * std::sin(7 * theta) +
                        0.02 * std::sin(41 * phi + 13 * theta) + 0.004 * std::cos(173 * theta - 97 * phi);
    const double r = 1.0 + bump * std::sin(theta);
    return {r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi)};
}

}  // namespace

BumpySphere::BumpySphere(int triangleCount) {
    const int rings = std::max(3, static_cast<int>(std::lround(std::sqrt(triangleCount / 4.0)))),
              segments = 2 * rings;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= segments; ++j)
            vertices.push_back(bumpyPoint(std::numbers::pi * i / rings, 2 * std::numbers::pi * j / segments));
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < segments; ++j) {
            const auto a = static_cast<unsigned>(i * (segments + 1) + j),
                       b = a + static_cast<unsigned>(segments) + 1;
            triangles.emplace_back(a, b, a + 1);
            triangles.emplace_back(a + 1, b, b + 1);
        }
}

}  // namespace rayscope::bench
