// Nodes of glTF files: scenes, skins, morph targets, instances, and many of them.
#include <rayscope/scene.h>

#include <stop_token>

#include "gltf_files.h"

namespace rayscope::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class GltfNodes : public GltfFiles {};

TEST_F(GltfNodes, SelectsTheScene) {
    const GltfBuilder file = triangle();
    const auto meshAt = [&](const std::string& scenes) {
        notes_.clear();
        return meshOf(read(file.embedded(
            oneMesh(kPositions, R"("nodes":[{"mesh":0},{"mesh":0,"translation":[9,0,0]}])" + scenes))));
    };
    EXPECT_EQ(meshAt(R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])").positions[0].x, 9.0f);
    EXPECT_THAT(notesText(), HasSubstr("note: 2 scenes; only scene 1 is read"));
    EXPECT_EQ(meshAt(R"(,"scenes":[{"nodes":[0]},{"nodes":[1]}])").positions[0].x, 0.0f);
    EXPECT_EQ(meshAt("").triangles.size(), 2u);
    EXPECT_THAT(notesText(), HasSubstr("note: no scene; all nodes are read"));
    EXPECT_EQ(meshAt(R"(,"scenes":[{"nodes":[0,1,0]}])").triangles.size(), 2u);
    EXPECT_THAT(notesText(), HasSubstr("warning: nodes with several parents"));
}

TEST_F(GltfNodes, DeepNodesAreRead) {
    const GltfBuilder file = triangle();
    std::string nodes;
    constexpr int kDepth = 100'000;
    for (int i = 1; i < kDepth; ++i) nodes += fmt::format(R"({{"children":[{}]}},)", i);
    const std::string others = fmt::format(R"("nodes":[{}{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])", nodes);
    EXPECT_EQ(meshOf(read(file.embedded(oneMesh(kPositions, others)))).triangles.size(), 1u);
}

TEST_F(GltfNodes, ManyPrimitivesTakeLinearTime) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    std::string primitives = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
    constexpr std::size_t kCount = 50'000;
    for (std::size_t i = 1; i < kCount; ++i) primitives += R"(,{"attributes":{"POSITION":0}})";
    const auto scene =
        read(file.embedded(fmt::format(R"("meshes":[{{"primitives":[{}]}}],{})", primitives, kNode)));
    EXPECT_EQ(meshOf(scene).triangles.size(), kCount);
    EXPECT_EQ(meshOf(scene).normals.size(), 3 * kCount);
}

TEST_F(GltfNodes, SkinsMoveVerticesToTheirJoints) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
    file.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4");
    std::vector<float> inverse(32, 0.0f);
    for (const std::size_t i : {0u, 5u, 10u, 15u}) inverse[i] = inverse[16 + i] = 1.0f;
    inverse[16 + 12] = -1.0f;  // joint 1 was at (1, 0, 0)
    file.accessor(inverse, "MAT4");
    const std::string mesh = R"("attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2})";
    const auto positions = [&](const std::string& skins) {
        return meshOf(read(file.embedded(oneMesh(
                          mesh,
                          R"("nodes":[{"mesh":0,"skin":0,"translation":[9,9,9],"children":[1]},)"
                          R"({"children":[2]},{"translation":[1,2,0]}],"scenes":[{"nodes":[0]}],"skins":)" +
                              skins))))
            .positions;
    };
    // Node 1 is moved by its parent, whose own mesh ignores this.
    EXPECT_THAT(positions(R"([{"joints":[1,2],"inverseBindMatrices":3}])"),
                ElementsAre(glm::vec3(9, 9, 9), glm::vec3(10, 11, 9), glm::vec3(9, 11, 9)));
    EXPECT_THAT(positions(R"([{"joints":[1,2]}])"),
                ElementsAre(glm::vec3(9, 9, 9), glm::vec3(11, 11, 9), glm::vec3(9.5f, 11, 9)));
    EXPECT_TRUE(notes_.empty()) << notesText();
    EXPECT_EQ(
        failure(file.embedded(oneMesh(
            mesh, R"("nodes":[{"mesh":0,"skin":0}],"scenes":[{"nodes":[0]}],"skins":[{"joints":[0]}])"))),
        "m.gltf: error: accessors[1]: joint 1 is out of range: the skin has 1 joints");
    read(file.embedded(oneMesh(
        kPositions, R"("nodes":[{"mesh":0,"skin":0}],"scenes":[{"nodes":[0]}],"skins":[{"joints":[0]}])")));
    EXPECT_THAT(notesText(), HasSubstr("warning: skinned primitives without joints and weights"));
}

TEST_F(GltfNodes, MorphTargetsAreWeighted) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<float>{0, 0, 2, 0, 0, 2, 0, 0, 2}, "VEC3");
    const std::string mesh =
        R"("meshes":[{"weights":[0.5,0],"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1},{"POSITION":1}]}]}],)";
    const auto heightOf = [&](const std::string& node) {
        return meshOf(read(file.embedded(mesh + R"("nodes":[{"mesh":0)" + node +
                                         R"(}],"scenes":[{"nodes":[0]}])")))
            .positions[1]
            .z;
    };
    EXPECT_EQ(heightOf(""), 1.0f);
    EXPECT_EQ(heightOf(R"(,"weights":[1,0.25])"), 2.5f) << "the node replaces the weights";
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfNodes, InstancesAreSeparate) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<float>{1, 0, 0, 0, 0, 5}, "VEC3");
    file.accessor(std::vector<float>{1, 1, 1, -2, 1, 1}, "VEC3");
    file.accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 0, 127}, "VEC4", R"(,"normalized":true)");
    const MeshData mesh = meshOf(read(file.embedded(oneMesh(
        kPositions,
        R"("extensionsRequired":["EXT_mesh_gpu_instancing"],"nodes":[{"mesh":0,"translation":[0,3,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1,"SCALE":2,"ROTATION":3}}}}],"scenes":[{"nodes":[0]}])"))));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_LT(glm::length(mesh.positions[1] - glm::vec3(0, 3, 0)), 1e-6f)
        << "turned half round z, then moved";
    EXPECT_EQ(mesh.positions[4], glm::vec3(-2, 3, 5));
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(3, 5, 4)) << "mirrored";
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfNodes, ReadingStopsOnRequest) {
    std::stop_source stop;
    stop.request_stop();
    const std::string path = write("m.gltf", triangle().embedded(oneMesh(kPositions)));
    EXPECT_THROW(loadScene(path, notes_, {.stop = stop.get_token()}), Stopped);
}

}  // namespace
}  // namespace rayscope::test
