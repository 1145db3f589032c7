#include "viewer/view/simplify_mesh.h"

#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

#include <cmath>

#include "viewer/gl/mesh_buffer.h"

namespace rayscope::viewer {
namespace {

double areaOf(const MeshData& mesh) {
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        area += 0.5 * static_cast<double>(glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                                                 mesh.positions[t.z] - mesh.positions[t.x])));
    return area;
}

TEST(SimplifyMesh, ResemblesTheMesh) {
    const MeshData sphere = unitSphereMesh();  // 4096 triangles
    const MeshData coarse = simplifyMesh(sphere, 1000);
    EXPECT_LE(coarse.triangles.size(), 1000u);
    EXPECT_GT(coarse.triangles.size(), 250u);
    EXPECT_NEAR(areaOf(coarse), areaOf(sphere), 0.15 * areaOf(sphere));
    ASSERT_EQ(coarse.normals.size(), coarse.positions.size());
    for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(coarse.positions[i]), 1.0f, 0.1f);
        EXPECT_GT(glm::dot(glm::normalize(coarse.normals[i]), glm::normalize(coarse.positions[i])), 0.9f);
    }
    for (const glm::uvec3& triangle : coarse.triangles)
        EXPECT_LT(std::max({triangle.x, triangle.y, triangle.z}), coarse.positions.size());
}

TEST(SimplifyMesh, KeepsVertexColors) {
    MeshData sphere = unitSphereMesh();
    for (const glm::vec3& position : sphere.positions) sphere.colors.push_back(0.5f * position + 0.5f);
    const MeshData coarse = simplifyMesh(sphere, 1000);
    ASSERT_EQ(coarse.colors.size(), coarse.positions.size());
    for (std::size_t i = 0; i < coarse.colors.size(); ++i)
        EXPECT_LT(glm::distance(coarse.colors[i], 0.5f * coarse.positions[i] + 0.5f), 0.2f);
}

TEST(SimplifyMesh, KeepsSmallMeshes) {
    const MeshData sphere = unitSphereMesh();
    EXPECT_EQ(simplifyMesh(sphere, sphere.triangles.size()).triangles, sphere.triangles);
    EXPECT_TRUE(simplifyMesh({}, 10).triangles.empty());
}

/// Triangles of 0.1 that do not touch one another, on a line; every second one of slot 1.
MeshData separateTriangles(std::uint32_t count) {
    MeshData mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 offset(static_cast<float>(i), 0.0f, 0.0f);
        for (const glm::vec3 corner : {glm::vec3(0, 0, 0), glm::vec3(0.1, 0, 0), glm::vec3(0, 0.1, 0)})
            mesh.positions.push_back(offset + corner);
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        mesh.materialSlots.push_back(i % 2);
    }
    return mesh;
}

TEST(SimplifyMesh, KeepsASubsetOfUnconnectedTriangles) {
    const MeshData coarse = simplifyMesh(separateTriangles(100000), 1001);
    ASSERT_EQ(coarse.triangles.size(), 1001u);
    ASSERT_EQ(coarse.materialSlots.size(), 1001u);
    EXPECT_TRUE(coarse.colors.empty());
    EXPECT_LT(coarse.triangles.front().x, 300u);
    EXPECT_GT(coarse.triangles.back().x, 299000u);
}

TEST(SimplifyMesh, ToleratesNonFiniteAndCoincidentVertices) {
    MeshData mesh = unitSphereMesh();
    mesh.positions[5] = glm::vec3(std::nanf(""));
    mesh.positions[50].x = std::numeric_limits<float>::infinity();
    for (const glm::vec3& position : simplifyMesh(mesh, 500).positions)
        EXPECT_TRUE(std::isfinite(glm::dot(position, position)));
    for (glm::vec3& position : mesh.positions) position = glm::vec3(3.0f);
    EXPECT_LE(simplifyMesh(mesh, 500).triangles.size(), 500u);
    for (glm::vec3& position : mesh.positions) position = glm::vec3(std::nanf(""));
    EXPECT_LE(simplifyMesh(mesh, 500).triangles.size(), 500u);
}

TEST(SimplifyMesh, StopsOnRequest) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(simplifyMesh(unitSphereMesh(), 100, stop.get_token()), Stopped);
}

}  // namespace
}  // namespace rayscope::viewer
