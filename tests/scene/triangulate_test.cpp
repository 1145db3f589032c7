#include "scene/mesh_files/geometry/triangulate.h"

#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rayscope {
namespace {

struct Triangulation {
    std::vector<glm::uvec3> triangles;
    double area = 0.0;      ///< sum of the signed areas along `normal`
    double smallest = 0.0;  ///< the smallest signed area
};

Triangulation triangulate(const std::vector<glm::vec3>& points, glm::dvec3 normal) {
    Triangulation result;
    result.triangles.resize(points.size() - 2);
    scene::triangulate(points, result.triangles);
    result.smallest = 1e30;
    for (const glm::uvec3& t : result.triangles) {
        const glm::dvec3 a(points[t.x]), b(points[t.y]), c(points[t.z]);
        const double area = 0.5 * glm::dot(glm::cross(b - a, c - a), normal);
        result.area += area;
        result.smallest = std::min(result.smallest, area);
    }
    return result;
}

TEST(Triangulate, ConvexPolygonsBecomeFans) {
    const Triangulation quad = triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 0, 1});
    EXPECT_DOUBLE_EQ(quad.area, 1.0);
    EXPECT_EQ(quad.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(quad.triangles[1], glm::uvec3(0, 2, 3));
}

TEST(Triangulate, ConcavePolygonsAreCoveredExactly) {
    // An arrow head: the fan around its first corner is not inside it.
    const Triangulation arrow = triangulate({{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}}, {0, 0, 1});
    EXPECT_DOUBLE_EQ(arrow.area, 1.0);
    EXPECT_GT(arrow.smallest, 0.0);
    // A comb in a plane that is not perpendicular to an axis.
    std::vector<glm::vec3> comb;
    for (int i = 0; i < 6; ++i) {
        comb.emplace_back(i, 0, i);
        comb.emplace_back(i + 0.5, i == 5 ? 0 : 3, i + 0.5);
    }
    comb.emplace_back(5.5, -1, 5.5);
    comb.emplace_back(0, -1, 0);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0, -1));
    const Triangulation teeth = triangulate(comb, normal);
    double expected = 0.0;
    for (std::size_t i = 0; i < comb.size(); ++i)
        expected +=
            0.5 * glm::dot(glm::cross(glm::dvec3(comb[i]), glm::dvec3(comb[(i + 1) % comb.size()])), normal);
    EXPECT_NEAR(teeth.area, expected, 1e-9);
    EXPECT_GT(teeth.smallest * (expected > 0 ? 1 : -1) + 1e-12, 0.0);
}

/// Whether an outline is covered exactly: no triangle is turned over, and the areas add up.
void expectCovered(const std::vector<glm::dvec2>& outline, const char* name) {
    SCOPED_TRACE(name);
    std::vector<glm::vec3> points;
    for (const glm::dvec2& p : outline) points.emplace_back(p.x, p.y, 0.0);
    double expected = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 a(points[i]), b(points[(i + 1) % points.size()]);
        expected += 0.5 * (a.x * b.y - a.y * b.x);
        scale += std::abs(a.x * b.y) + std::abs(a.y * b.x);
    }
    std::vector<glm::uvec3> triangles(points.size() - 2);
    EXPECT_TRUE(scene::triangulate(points, triangles));
    double area = 0.0, smallest = 0.0;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a(points[t.x]), b(points[t.y]), c(points[t.z]);
        const double own = 0.5 * glm::cross(b - a, c - a).z;
        area += own;
        smallest = std::min(smallest, own);
    }
    EXPECT_NEAR(area, expected, 1e-14 * scale);
    EXPECT_GE(smallest, 0.0);
}

glm::dvec2 polar(double radius, double angle) {
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

TEST(Triangulate, LargeOutlinesAreCoveredExactly) {
    constexpr int kCorners = 20000;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.3, 1.0);
    std::vector<glm::dvec2> circle, star, spiral, comb, stairs;
    for (int i = 0; i < kCorners; ++i) circle.push_back(polar(1.0, 2.0 * M_PI * i / kCorners));
    for (int i = 0; i < kCorners; ++i) star.push_back(polar(uniform(random), 2.0 * M_PI * i / kCorners));
    for (int i = 0; i < kCorners / 2; ++i) spiral.push_back(polar(1.0 + 1e-3 * i, 3e-3 * i));
    for (int i = kCorners / 2; i-- > 0;) spiral.push_back(polar(0.5 + 1e-3 * i, 3e-3 * i));
    for (int i = 0; i < kCorners; ++i) comb.emplace_back(i, i % 2 == 0 ? 1.0 : 1000.0);
    comb.emplace_back(kCorners, 0.0);
    comb.emplace_back(0.0, 0.0);
    std::reverse(comb.begin(), comb.end());
    for (int i = 0; i < kCorners / 2; ++i) {
        stairs.emplace_back(i, i);
        stairs.emplace_back(i + 1, i);
    }
    stairs.emplace_back(0, kCorners / 2);
    expectCovered(circle, "circle");
    expectCovered(star, "star");
    expectCovered(spiral, "spiral");
    expectCovered(comb, "comb");
    expectCovered(stairs, "stairs");
}

TEST(Triangulate, HolesOnBridgesAndSpikesAreCoveredExactly) {
    for (const int rows : {1, 3, 500}) {
        std::vector<glm::dvec2> holes{{0, 0}, {100, 0}, {100, rows + 1}, {0, rows + 1}};
        for (int y = rows; y > 0; --y)  // down the left edge, to each hole and back
            holes.insert(holes.end(), {{0, y}, {1, y}, {1, y - 0.5}, {90, y - 0.5}, {90, y}, {1, y}, {0, y}});
        expectCovered(holes, "holes");
    }
    expectCovered({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}}, "a spike without area");
    expectCovered({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}}, "a slit");
    expectCovered({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {1, 1}, {0, 4}, {0, 4}}, "repeated corners");
    expectCovered({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {1, 3}, {0, 3}}, "collinear corners");
    expectCovered({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, "touches its edge");
}

TEST(Triangulate, OutlinesThatCrossThemselvesAreReported) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    for (const std::size_t corners : {4u, 20u, 100u, 30000u}) {
        std::vector<glm::vec3> points(corners);
        for (glm::vec3& p : points) p = {uniform(random), uniform(random), 0.0f};
        if (corners == 4) points = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}};
        std::vector<glm::uvec3> triangles(corners - 2, glm::uvec3(~0u));
        EXPECT_FALSE(scene::triangulate(points, triangles)) << corners;
        std::vector<bool> isUsed(corners);
        for (const glm::uvec3& t : triangles)
            for (int i = 0; i < 3; ++i) isUsed.at(t[i]) = true;
        EXPECT_EQ(std::count(isUsed.begin(), isUsed.end(), true), static_cast<std::ptrdiff_t>(corners));
    }
}

TEST(Triangulate, ALargePolygonCanBeStopped) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < 10000; ++i)
        points.emplace_back(polar(i % 2 == 0 ? 1.0 : 0.5, 2.0 * M_PI * i / 10000), 0.0);
    std::vector<glm::uvec3> triangles(points.size() - 2);
    std::size_t last = 0;
    EXPECT_THROW(scene::triangulate(points, triangles,
                                    [&](std::size_t done) {
                                        last = done;
                                        if (done > 100) throw Stopped();
                                    }),
                 Stopped);
    EXPECT_EQ(last, 101u);
}

/// A test of every corner against all corners at the same place would take hours.
TEST(Triangulate, OutlinesThatRepeatTheirCornersAreNotSimple) {
    const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::vector<glm::vec3> points;
    for (int i = 0; i < 100000; ++i) points.insert(points.end(), square.begin(), square.begin() + 3 + i % 2);
    std::vector<glm::uvec3> triangles(points.size() - 2, glm::uvec3(~0u));
    EXPECT_FALSE(scene::triangulate(points, triangles));
    for (const glm::uvec3& t : triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), points.size());
}

TEST(Triangulate, InvalidPolygonsStillFillAllTriangles) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto& points : {std::vector<glm::vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                               std::vector<glm::vec3>(5, glm::vec3(1.0f)),
                               std::vector<glm::vec3>{{0, 0, 0}, {nan, 1, 0}, {1, 0, 0}, {0, 1, 0}}}) {
        std::vector<glm::uvec3> triangles(points.size() - 2, glm::uvec3(99));
        scene::triangulate(points, triangles);
        for (const glm::uvec3& t : triangles)
            for (int i = 0; i < 3; ++i) EXPECT_LT(t[i], points.size());
    }
}

}  // namespace
}  // namespace rayscope
