// Origins of spawned rays: on the right side of the surface, and within the stated distance.
#include "math/spawn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measure/lab/exact_sum.h"

namespace rayscope::test {
namespace {

/// A random triangle of any shape and size, close to or far from the origin.
struct RandomTriangle {
    glm::vec3 a, b, c;
    glm::dvec3 normal;
    bool hasArea;
};

RandomTriangle randomTriangle(std::mt19937_64& random) {
    std::uniform_real_distribution<double> real(-1.0, 1.0);
    const auto point = [&] { return glm::dvec3(real(random), real(random), real(random)); };
    const double size = std::exp2(60.0 * real(random)),
                 offset = random() % 2 ? std::pow(10.0, 3.0 + 3.0 * real(random)) : 0.0;
    const glm::dvec3 at = size * offset * point();
    RandomTriangle t;
    t.a = glm::vec3(at + size * point());
    t.b = glm::vec3(glm::dvec3(t.a) + size * std::exp2(-5.0 + 5.0 * real(random)) * point());
    t.c = glm::vec3(glm::dvec3(t.a) + size * std::exp2(-5.0 + 5.0 * real(random)) * point());
    const glm::dvec3 n =
        glm::cross((glm::dvec3(t.b) - glm::dvec3(t.a)) / size, (glm::dvec3(t.c) - glm::dvec3(t.a)) / size);
    t.hasArea = glm::dot(n, n) > 0.0;
    t.normal = t.hasArea ? glm::normalize(n) : n;
    return t;
}

TEST(Spawn, OriginIsOnTheSideOfTheNormalAndClose) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> real(0.0, 1.0);
    double farthest = 0.0;
    int tried = 0;
    for (int i = 0; i < 300000; ++i) {
        const RandomTriangle t = randomTriangle(random);
        if (!t.hasArea) continue;
        double u = real(random), v = real(random);
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const glm::dvec3 a = t.a, b = t.b, c = t.c;
        const glm::dvec3 point = (1.0 - u - v) * a + u * b + v * c;
        const glm::dvec3 magnitude = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
        for (const double side : {1.0, -1.0}) {
            const glm::vec3 origin = math::spawnOrigin(point, magnitude, side * t.normal);
            ASSERT_EQ(measure::signedVolume(t.a, t.b, t.c, origin).sign(), side > 0.0 ? 1 : -1) << i;
            const double bound = math::spawnDistance(point, magnitude, side * t.normal);
            const double distance = glm::dot(glm::dvec3(origin) - point, side * t.normal);
            farthest = std::max(farthest, distance / bound);
            ++tried;
        }
    }
    EXPECT_GT(tried, 400000);
    // The offset itself, plus the final rounding by up to one unit in the last place per coordinate: two
    // more.
    EXPECT_LE(farthest, 3.1);
    EXPECT_GE(farthest, 0.5);
}

}  // namespace
}  // namespace rayscope::test
