#include "scene/mesh_files/triangulate.h"

#include <gtest/gtest.h>

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
