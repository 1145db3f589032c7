#include "bvh/intersect/intersect_triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bvh/meshes.h"
#include "support/non_finite.h"

namespace rayscope::test {
namespace {

using bvh::kernel::ShearedVertex;

struct Case {
    Ray ray;
    glm::vec3 a, b, c;
};

/// Rays at, near and beside edges and vertices of triangles of all shapes and sizes.
Case someCase(Random& random) {
    const double size = std::exp2(random.real(-40, 40));
    Case test;
    test.a = glm::vec3(size * glm::dvec3(random.inCube()));
    test.b = test.a + glm::vec3(size * std::exp2(-random.real(0, 20)) * glm::dvec3(random.inCube()));
    test.c = test.a + glm::vec3(size * std::exp2(-random.real(0, 20)) * glm::dvec3(random.inCube()));
    const glm::dvec3 a = test.a, b = test.b, c = test.c;
    const double along = random.integer(3) ? random.real() : 0.0;
    const double aside =
        random.integer(3) ? (random.integer(2) ? 1 : -1) * std::pow(10.0, random.real(-9, 0)) : 0.0;
    test.ray.origin = glm::vec3(size * std::exp2(random.real(-2, 6)) * random.onSphere());
    test.ray.direction = glm::vec3(a + along * (b - a) + aside * (c - a) - glm::dvec3(test.ray.origin));
    return test;
}

bool sameBits(const bvh::TriangleHit& x, const bvh::TriangleHit& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
}

TEST(IntersectTriangle, EarlyMissEqualsTheExactTest) {
    Random random(1);
    int rejected = 0, hits = 0;
    for (int i = 0; i < 300000; ++i) {
        const Case test = someCase(random);
        const bvh::ShearedRay ray(bvh::rayData(test.ray));
        const ShearedVertex a = shear(ray, &test.a.x), b = shear(ray, &test.b.x), c = shear(ray, &test.c.x);
        bvh::TriangleHit fast{}, exact{};
        const bool fastHits = bvh::intersectTriangle(ray, test.a, test.b, test.c, fast);
        const bool exactHits = intersectSheared(ray.scaleZ, a, b, c, exact);
        ASSERT_EQ(fastHits, exactHits) << text(test.ray);
        if (exactHits) {
            ASSERT_TRUE(sameBits(fast, exact));
        }
        rejected += certainlyMisses(a, b, c);
        hits += exactHits;
    }
    EXPECT_GT(rejected, 30000);
    EXPECT_GT(hits, 30000);
}

TEST(IntersectTriangle, WeightsDescribeTheHitPoint) {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        Case test = someCase(random);
        bvh::TriangleHit hit;
        if (!bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData(test.ray)), test.a, test.b, test.c, hit))
            continue;
        ASSERT_GE(hit.u, 0.0);
        ASSERT_GE(hit.v, 0.0);
        ASSERT_LE(hit.u + hit.v, 1.0 + 0x1p-50);
        const glm::dvec3 a = test.a, b = test.b, c = test.c, o = test.ray.origin, d = test.ray.direction;
        const glm::dvec3 onRay = o + hit.t * d,
                         onTriangle = (1.0 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
        // Both are the sheared point up to double rounding of coordinates of this size; slivers seen edge-on
        // trade position along the ray for position across it.
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double grazing = glm::length(normal) * glm::length(d) / std::abs(glm::dot(normal, d));
        const double size =
            std::max({glm::length(a - o), glm::length(b - o), glm::length(c - o), glm::length(o)});
        ASSERT_LE(glm::length(onRay - onTriangle), 0x1p-46 * size * std::min(grazing, 0x1p40))
            << text(test.ray);
    }
}

/// Only the weights are permuted, and t may change by double rounding.
TEST(IntersectTriangle, OrderOfVerticesDoesNotMatter) {
    Random random(3);
    for (int i = 0; i < 50000; ++i) {
        const Case test = someCase(random);
        const bvh::ShearedRay ray(bvh::rayData(test.ray));
        const glm::vec3 v[3] = {test.a, test.b, test.c};
        bvh::TriangleHit first{};
        const bool hits = bvh::intersectTriangle(ray, v[0], v[1], v[2], first);
        for (const auto& [x, y, z] : {std::array{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
            bvh::TriangleHit other{};
            ASSERT_EQ(bvh::intersectTriangle(ray, v[x], v[y], v[z], other), hits) << text(test.ray);
            if (!hits) continue;
            const double scale = std::max(std::abs(first.t), 1e-3);
            ASSERT_NEAR(other.t, first.t, 0x1p-40 * scale * std::max(1.0, 1.0 / std::abs(first.t)));
        }
    }
}

TEST(IntersectTriangle, DegenerateAndNonFiniteTrianglesAreMissed) {
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        Case test = someCase(random);
        const bvh::ShearedRay ray(bvh::rayData(test.ray));
        bvh::TriangleHit hit;
        ASSERT_FALSE(bvh::intersectTriangle(ray, test.a, test.b, test.b, hit));
        ASSERT_FALSE(bvh::intersectTriangle(ray, test.a, test.b, test.a, hit));
        ASSERT_FALSE(bvh::intersectTriangle(ray, test.a, test.a, test.a, hit));
        const glm::vec3 step(1, random.integer(5) - 2, random.integer(5) - 2);
        ASSERT_FALSE(bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData({{1, 2, 3}, step * 2.0f})),
                                            glm::vec3(1, 2, 3) + step, glm::vec3(1, 2, 3) + 2.0f * step,
                                            glm::vec3(1, 2, 3) + 3.0f * step, hit));
        test.b[random.integer(3)] = random.integer(3) ? (random.integer(2) ? kInfinity : -kInfinity) : kNaN;
        ASSERT_FALSE(bvh::intersectTriangle(ray, test.a, test.b, test.c, hit));
        ASSERT_FALSE(bvh::intersectTriangle(ray, test.b, test.c, test.a, hit));
    }
}

TEST(IntersectTriangle, EdgeOnTrianglesAreMissed) {
    bvh::TriangleHit hit;
    for (const glm::vec3& direction : {glm::vec3(1, 0, 0), {0, -1, 0}, {1, 1, 0}, {-3, 2, -0.0f}})
        for (const glm::vec3& origin : {glm::vec3(0), {-5, -3, 0}, {0.25f, 0.25f, 0}})
            EXPECT_FALSE(bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData({origin, direction})), {0, 0, 0},
                                                {1, 0, 0}, {0, 1, 0}, hit));
}

TEST(IntersectTriangle, ExtremeSizes) {
    for (int exponent = -120; exponent <= 120; exponent += 5) {
        const float s = std::ldexp(1.0f, exponent);
        bvh::TriangleHit hit;
        ASSERT_TRUE(bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData({{s, s, -s}, {0, 0, s}})), {0, 0, 0},
                                           {3 * s, 0, 0}, {0, 3 * s, 0}, hit));
        EXPECT_EQ(hit.t, 1.0);
        EXPECT_DOUBLE_EQ(hit.u, 1.0 / 3.0);
        EXPECT_DOUBLE_EQ(hit.v, 1.0 / 3.0);
    }
}

}  // namespace
}  // namespace rayscope::test
