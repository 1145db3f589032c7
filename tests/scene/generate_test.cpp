#include "scene/generate.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>

namespace rayscope {
namespace {

/// How often each directed edge occurs, with vertices told apart by their position only.
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

/// Every edge is run through once in each direction: no hole, no fin, one orientation.
bool isClosed(const MeshData& mesh) {
    const auto edges = directedEdges(mesh);
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

void expectSound(const MeshData& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_TRUE(mesh.texCoords.empty() || mesh.texCoords.size() == mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 4e-7f);
    std::size_t against = 0, flat = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) ASSERT_LT(t[i], mesh.positions.size());
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 area = glm::cross(b - a, c - a);
        flat += area == glm::vec3(0.0f);
        against += glm::dot(area, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) < 0.0f;
    }
    EXPECT_EQ(flat, 0u);
    EXPECT_EQ(against, 0u);
}

TEST(Generate, QuadFacesTheViewerOnThePositiveSide) {
    const MeshData quad = scene::generate(scene::QuadShape{{2.0f, 1.0f}});
    expectSound(quad);
    EXPECT_EQ(quad.triangles.size(), 2u);
    EXPECT_EQ(quad.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(quad.positions[0], glm::vec3(-1, -0.5f, 0));
    EXPECT_EQ(quad.texCoords[0], glm::vec2(0, 0)) << "lower left";
}

TEST(Generate, BoxIsClosedAndHasTheVolumeOfItsSides) {
    const MeshData box = scene::generate(scene::BoxShape{{1.0f, 2.0f, 4.0f}});
    expectSound(box);
    EXPECT_EQ(box.triangles.size(), 12u);
    EXPECT_TRUE(isClosed(box));
    EXPECT_DOUBLE_EQ(volumeOf(box), 8.0);
    const MeshData room = scene::generate(scene::BoxShape{{1.0f, 2.0f, 4.0f}, true});
    expectSound(room);
    EXPECT_TRUE(isClosed(room));
    EXPECT_DOUBLE_EQ(volumeOf(room), -8.0);
}

TEST(Generate, SpheresAreClosedAndNearlyRound) {
    const MeshData uv = scene::generate(scene::UvSphereShape{2.0f, 48, 24});
    expectSound(uv);
    EXPECT_EQ(uv.triangles.size(), 2u * 48u * 23u);
    EXPECT_TRUE(isClosed(uv));
    const MeshData ico = scene::generate(scene::IcosphereShape{2.0f, 3});
    expectSound(ico);
    EXPECT_EQ(ico.triangles.size(), 20u * 64u);
    EXPECT_TRUE(isClosed(ico));
    const double ball = 4.0 / 3.0 * 3.14159265358979 * 8.0;
    EXPECT_NEAR(volumeOf(uv), ball, 0.02 * ball);
    EXPECT_NEAR(volumeOf(ico), ball, 0.02 * ball);
    for (const glm::vec3& p : ico.positions) EXPECT_NEAR(glm::length(p), 2.0f, 1e-6f);
}

TEST(Generate, TorusHasPappusVolume) {
    const MeshData torus = scene::generate(scene::TorusShape{1.0f, 0.25f, 128, 64});
    expectSound(torus);
    EXPECT_EQ(torus.triangles.size(), 2u * 128u * 64u);
    EXPECT_TRUE(isClosed(torus));
    const double pi = 3.14159265358979, expected = 2.0 * pi * pi * 0.0625;
    EXPECT_NEAR(volumeOf(torus), expected, 0.01 * expected);
}

TEST(Generate, TerrainIsASheetWithTrueNormals) {
    const scene::TerrainShape shape{{2.0f, 1.0f}, 0.3f, 400, 200, 3};
    const MeshData terrain = scene::generate(shape);
    expectSound(terrain);
    EXPECT_EQ(terrain.triangles.size(), 160000u);
    std::size_t rim = 0;
    const auto edges = directedEdges(terrain);
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        rim += !edges.contains({edge.second, edge.first});
    }
    EXPECT_EQ(rim, 2u * (400u + 200u));
    for (const glm::vec3& p : terrain.positions) {
        EXPECT_GE(p.y, 0.0f);
        EXPECT_LE(p.y, 0.3f);
    }
    // The same hills from the same seed, others from another.
    EXPECT_EQ(scene::generate(shape).positions, terrain.positions);
    scene::TerrainShape other = shape;
    other.seed = 4;
    EXPECT_NE(scene::generate(other).positions, terrain.positions);
}

TEST(Generate, TeapotHas15704TrianglesAndOnlyItsKnownRims) {
    const MeshData teapot = scene::generate(scene::TeapotShape{});
    expectSound(teapot);
    EXPECT_EQ(teapot.triangles.size(), 15704u);
    // Open are the rim of the body, the rim of the lid, and the two ends of the handle and of the spout.
    std::size_t rim = 0;
    const auto edges = directedEdges(teapot);
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        rim += !edges.contains({edge.second, edge.first});
    }
    EXPECT_EQ(rim, 4u * 16u + 4u * 16u + 2u * (2u * 16u) + 2u * (2u * 14u));
}

TEST(Generate, TeapotHasNewellsMeasures) {
    const MeshData teapot = scene::generate(scene::TeapotShape{32});
    glm::vec3 lower(1e9f), upper(-1e9f);
    for (const glm::vec3& p : teapot.positions) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    EXPECT_FLOAT_EQ(lower.y, 0.0f);
    EXPECT_FLOAT_EQ(upper.y, 3.15f);
    EXPECT_NEAR(lower.x, -3.0, 0.01);
    EXPECT_NEAR(upper.x, 3.434, 0.005) << "the lip of the spout";
    EXPECT_NEAR(upper.z, 2.0, 0.005) << "the belly";
    EXPECT_FLOAT_EQ(lower.z, -upper.z);
}

TEST(Generate, TeapotOfEveryResolutionHasNoCracks) {
    for (const int resolution : {1, 3, 7, 20}) {
        const MeshData teapot = scene::generate(scene::TeapotShape{resolution});
        // The coarsest are too angular for their normals to agree with every face.
        if (resolution > 3) expectSound(teapot);
        for (const auto& [edge, count] : directedEdges(teapot)) ASSERT_EQ(count, 1);
    }
}

TEST(Generate, MonkeyIsClosedAndWatertightAtEveryResolution) {
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
