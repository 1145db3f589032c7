#include "scene/generate/generate.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>

namespace rayscope {
namespace {

/// The number of occurrences of each directed edge, with vertices identified by position.
using Point = std::tuple<float, float, float>;
std::map<std::pair<Point, Point>, int> directedEdges(const MeshData& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    const auto point = [&](std::uint32_t v) {
        const glm::vec3& p = mesh.positions[v];
        return Point(p.x, p.y, p.z);
    };
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) ++edges[{point(t[i]), point(t[(i + 1) % 3])}];
    return edges;
}

/// Whether each edge occurs once in each direction: closed, manifold and consistently oriented.
bool isClosed(const MeshData& mesh) {
    const auto edges = directedEdges(mesh);
    if (edges.empty()) return false;
    for (const auto& [edge, count] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        if (count != 1 || opposite == edges.end()) return false;
    }
    return true;
}

double volumeOf(const MeshData& mesh) {
    double volume = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += glm::dot(glm::dvec3(mesh.positions[t.x]),
                           glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
                  6.0;
    return volume;
}

void expectValid(const MeshData& mesh) {
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_TRUE(mesh.texCoords.empty() || mesh.texCoords.size() == mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 4e-7f);
    std::size_t flipped = 0, degenerate = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) ASSERT_LT(t[i], mesh.positions.size());
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 area = glm::cross(b - a, c - a);
        degenerate += area == glm::vec3(0.0f);
        flipped += glm::dot(area, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) < 0.0f;
    }
    EXPECT_EQ(degenerate, 0u);
    EXPECT_EQ(flipped, 0u);
}

TEST(Generate, QuadFacesPositiveZ) {
    const MeshData quad = scene::generate(scene::QuadShape{{2.0f, 1.0f}});
    expectValid(quad);
    EXPECT_EQ(quad.triangles.size(), 2u);
    EXPECT_EQ(quad.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(quad.positions[0], glm::vec3(-1, -0.5f, 0));
    EXPECT_EQ(quad.texCoords[0], glm::vec2(0, 0)) << "lower left";
}

TEST(Generate, BoxIsClosedAndHasItsVolume) {
    const MeshData box = scene::generate(scene::BoxShape{{1.0f, 2.0f, 4.0f}});
    expectValid(box);
    EXPECT_EQ(box.triangles.size(), 12u);
    EXPECT_TRUE(isClosed(box));
    EXPECT_DOUBLE_EQ(volumeOf(box), 8.0);
    const MeshData room = scene::generate(scene::BoxShape{{1.0f, 2.0f, 4.0f}, true});
    expectValid(room);
    EXPECT_TRUE(isClosed(room));
    EXPECT_DOUBLE_EQ(volumeOf(room), -8.0);
}

TEST(Generate, SpheresAreClosedAndNearlyRound) {
    const MeshData uv = scene::generate(scene::UvSphereShape{2.0f, 48, 24});
    expectValid(uv);
    EXPECT_EQ(uv.triangles.size(), 2u * 48u * 23u);
    EXPECT_TRUE(isClosed(uv));
    const MeshData ico = scene::generate(scene::IcosphereShape{2.0f, 3});
    expectValid(ico);
    EXPECT_EQ(ico.triangles.size(), 20u * 64u);
    EXPECT_TRUE(isClosed(ico));
    const double ball = 4.0 / 3.0 * 3.14159265358979 * 8.0;
    EXPECT_NEAR(volumeOf(uv), ball, 0.02 * ball);
    EXPECT_NEAR(volumeOf(ico), ball, 0.02 * ball);
    for (const glm::vec3& p : ico.positions) EXPECT_NEAR(glm::length(p), 2.0f, 1e-6f);
}

TEST(Generate, TorusHasTheVolumeByPappus) {
    const MeshData torus = scene::generate(scene::TorusShape{1.0f, 0.25f, 128, 64});
    expectValid(torus);
    EXPECT_EQ(torus.triangles.size(), 2u * 128u * 64u);
    EXPECT_TRUE(isClosed(torus));
    const double pi = 3.14159265358979, expected = 2.0 * pi * pi * 0.0625;
    EXPECT_NEAR(volumeOf(torus), expected, 0.01 * expected);
}

TEST(Generate, TerrainIsAConnectedHeightField) {
    const scene::TerrainShape shape{{2.0f, 1.0f}, 0.3f, 400, 200, 3};
    const MeshData terrain = scene::generate(shape);
    expectValid(terrain);
    EXPECT_EQ(terrain.triangles.size(), 160000u);
    std::size_t boundary = 0;
    const auto edges = directedEdges(terrain);
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        boundary += !edges.contains({edge.second, edge.first});
    }
    EXPECT_EQ(boundary, 2u * (400u + 200u));
    for (const glm::vec3& p : terrain.positions) {
        EXPECT_GE(p.y, 0.0f);
        EXPECT_LE(p.y, 0.3f);
    }
    // Determined by the seed.
    EXPECT_EQ(scene::generate(shape).positions, terrain.positions);
    scene::TerrainShape other = shape;
    other.seed = 4;
    EXPECT_NE(scene::generate(other).positions, terrain.positions);
}

TEST(Generate, TeapotHas15704TrianglesAndItsKnownBoundaries) {
    const MeshData teapot = scene::generate(scene::TeapotShape{});
    expectValid(teapot);
    EXPECT_EQ(teapot.triangles.size(), 15704u);
    // Boundaries: the rims of body and lid, and the two ends of the handle and of the spout.
    std::size_t boundary = 0;
    const auto edges = directedEdges(teapot);
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        boundary += !edges.contains({edge.second, edge.first});
    }
    EXPECT_EQ(boundary, 4u * 16u + 4u * 16u + 2u * (2u * 16u) + 2u * (2u * 14u));
}

TEST(Generate, TeapotHasNewellsDimensions) {
    const MeshData teapot = scene::generate(scene::TeapotShape{32});
    glm::vec3 lower(1e9f), upper(-1e9f);
    for (const glm::vec3& p : teapot.positions) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    EXPECT_FLOAT_EQ(lower.y, 0.0f);
    EXPECT_FLOAT_EQ(upper.y, 3.15f);
    EXPECT_NEAR(lower.x, -3.0, 0.01);
    EXPECT_NEAR(upper.x, 3.434, 0.005) << "tip of the spout";
    EXPECT_NEAR(upper.z, 2.0, 0.005) << "widest ring of the body";
    EXPECT_FLOAT_EQ(lower.z, -upper.z);
}

TEST(Generate, TeapotHasNoCracksAtAnyResolution) {
    for (const int resolution : {1, 3, 7, 20}) {
        const MeshData teapot = scene::generate(scene::TeapotShape{resolution});
        // At the lowest resolutions vertex normals deviate too much from face normals.
        if (resolution > 3) expectValid(teapot);
        const auto edges = directedEdges(teapot);
        ASSERT_FALSE(edges.empty());
        for (const auto& [edge, count] : edges) ASSERT_EQ(count, 1);
    }
}

TEST(Generate, MonkeyIsClosedAtEveryResolution) {
    const MeshData monkey = scene::generate(scene::MonkeyShape{});
    EXPECT_EQ(monkey.triangles.size(), 960u);
    for (const glm::vec3& normal : monkey.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 4e-7f);
    EXPECT_TRUE(isClosed(monkey));
    for (const int resolution : {8, 16, 23, 40}) {
        const MeshData mesh = scene::generate(scene::MonkeyShape{resolution});
        EXPECT_GT(volumeOf(mesh), 0.5);
        const auto edges = directedEdges(mesh);
        for (const auto& [edge, count] : edges) {
            const auto opposite = edges.find({edge.second, edge.first});
            ASSERT_TRUE(opposite != edges.end() && opposite->second == count);
        }
    }
}

}  // namespace
}  // namespace rayscope
