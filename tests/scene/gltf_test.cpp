// Geometry of glTF files: containers, buffers, accessors, primitives and nodes.
#include "gltf_files.h"

#include <cmath>

namespace rayscope::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Triangles = std::vector<glm::uvec3>;

class Gltf : public GltfFiles {};

TEST_F(Gltf, ReadsAllContainersAlike) {
    const GltfBuilder file = triangle();
    const std::string members = oneMesh(kPositions);
    write("a b.bin", file.binary());
    write("100%25.bin", file.binary());
    const struct {
        const char* name;
        std::string content;
    } cases[] = {{"data.gltf", file.embedded(members)},
                 {"type.gltf", file.json(members, "data:application/gltf-buffer;base64," +
                                                      GltfBuilder::base64(file.binary()))},
                 {"plain.gltf", file.json(members,
                                          "data:,%00%00%00%00%00%00%00%00%00%00%00%00%00%00%80%3f%00%00%00%00"
                                          "%00%00%00%00%00%00%00%00%00%00%80%3F%00%00%00%00")},
                 {"encoded.gltf", file.json(members, "a%20b.bin")},
                 {"blank.gltf", file.json(members, "a b.bin")},
                 {"literal.gltf", file.json(members, "100%25.bin")},
                 {"folder.gltf", file.json(members, "./x/../a b.bin")},
                 {"bom.gltf", "\xef\xbb\xbf" + file.embedded(members)},
                 {"binary.glb", file.glb(members)},
                 {"BINARY.GLB", file.glb(members)},
                 {"binary.gltf", file.glb(members)},
                 {"text.glb", file.embedded(members)}};
    for (const auto& [name, content] : cases) {
        const auto scene = load(write(name, content));
        EXPECT_EQ(meshOf(scene).positions[1], glm::vec3(1, 0, 0)) << name;
        EXPECT_EQ(meshOf(scene).triangles, Triangles{glm::uvec3(0, 1, 2)}) << name;
        EXPECT_EQ(scene.cameras.size(), 1u) << name;
        EXPECT_EQ(scene.lights.size(), 1u) << name;
    }
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(Gltf, ReadsAllPrimitiveModes) {
    const struct {
        int mode;
        Triangles expected;
    } cases[] = {{4, {{0, 1, 2}, {3, 2, 1}}}, {5, {{0, 1, 2}, {1, 3, 2}}}, {6, {{1, 2, 0}, {2, 3, 0}}}};
    for (const auto& [mode, expected] : cases) {
        GltfBuilder file;
        file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
        file.accessor(
            mode == 4 ? std::vector<std::uint16_t>{0, 1, 2, 3, 2, 1} : std::vector<std::uint16_t>{0, 1, 2, 3},
            "SCALAR");
        const auto scene =
            read(file.embedded(oneMesh(fmt::format(R"({},"indices":1,"mode":{})", kPositions, mode))));
        EXPECT_EQ(meshOf(scene).triangles, expected) << mode;
    }
    EXPECT_TRUE(notes_.empty()) << notesText();
    GltfBuilder file = triangle();
    const std::string both = fmt::format(
        R"("meshes":[{{"primitives":[{{{0}}},{{{0},"mode":0}},{{{0},"mode":1}},{{{0},"mode":3}}]}}],{1})",
        kPositions, kNode);
    EXPECT_EQ(meshOf(read(file.embedded(both))).triangles.size(), 1u);
    EXPECT_THAT(notesText(), HasSubstr("m.gltf: note: points; ignored\n"));
    EXPECT_THAT(notesText(), HasSubstr("m.gltf: note: lines; ignored (2 times)\n"));
}

TEST_F(Gltf, ReadsAllIndexTypes) {
    const auto check = [&](auto zero) {
        GltfBuilder file = triangle();
        file.accessor(std::vector<decltype(zero)>{2, 0, 1}, "SCALAR");
        const auto scene = read(file.embedded(oneMesh(kPositions + R"(,"indices":1)")));
        EXPECT_EQ(meshOf(scene).triangles, Triangles{glm::uvec3(2, 0, 1)});
    };
    check(std::uint8_t{});
    check(std::uint16_t{});
    check(std::uint32_t{});
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(Gltf, ReadsQuantizedAttributes) {
    const auto check = [&](auto zero, bool normalized, float expected) {
        using T = decltype(zero);
        GltfBuilder file;
        constexpr T top = std::numeric_limits<T>::max(), bottom = std::numeric_limits<T>::min();
        file.accessor(std::vector<T>{bottom, 0, 0, top, 0, 0, 0, top, 0}, "VEC3",
                      normalized ? R"(,"normalized":true)" : "");
        const auto scene = read(file.embedded(oneMesh(kPositions)));
        EXPECT_EQ(meshOf(scene).positions[1].x, expected);
        EXPECT_EQ(meshOf(scene).positions[0].x,
                  normalized ? std::max(static_cast<float>(bottom), -1.0f) : static_cast<float>(bottom));
    };
    check(std::int8_t{}, true, 1.0f);
    check(std::uint8_t{}, true, 1.0f);
    check(std::int16_t{}, true, 1.0f);
    check(std::uint16_t{}, true, 1.0f);
    check(std::int8_t{}, false, 127.0f);
    check(std::uint8_t{}, false, 255.0f);
    check(std::int16_t{}, false, 32767.0f);
    check(std::uint16_t{}, false, 65535.0f);
}

TEST_F(Gltf, ReadsStridesAndSparseAccessors) {
    GltfBuilder file;
    const std::vector<float> mixed{0, 0, 0, 9, 9, 1, 0,
                                   0, 9, 9, 0, 1, 0};  // a stride of 20 bytes, the last one cut
    file.view({reinterpret_cast<const char*>(mixed.data()), mixed.size() * 4}, R"(,"byteStride":20)");
    file.declare(R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3")");
    EXPECT_EQ(meshOf(read(file.embedded(oneMesh(kPositions)))).positions[2], glm::vec3(0, 1, 0));

    const auto sparse = [&](const std::string& base) {
        GltfBuilder sparseFile = triangle();
        sparseFile.view(std::string("\0\2", 2));
        const float values[] = {5, 6, 7, 8, 9, 10};
        sparseFile.view({reinterpret_cast<const char*>(values), sizeof values});
        sparseFile.declare(
            base +
            R"("componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}})");
        return meshOf(read(sparseFile.embedded(oneMesh(R"("attributes":{"POSITION":1})")))).positions;
    };
    EXPECT_THAT(sparse(R"("bufferView":0,)"),
                ElementsAre(glm::vec3(5, 6, 7), glm::vec3(1, 0, 0), glm::vec3(8, 9, 10)));
    EXPECT_THAT(sparse(""), ElementsAre(glm::vec3(5, 6, 7), glm::vec3(0), glm::vec3(8, 9, 10)));
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(Gltf, ReadsAttributes) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", R"(,"normalized":true)");
    file.accessor(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, "VEC2", R"(,"normalized":true)");
    file.accessor(std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}, "VEC4",
                  R"(,"normalized":true)");
    const auto scene = read(file.embedded(
        oneMesh(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3,"_OWN":0})")));
    const MeshData& mesh = meshOf(scene);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_THAT(mesh.texCoords, ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0, 0)))
        << "the origin is below";
    EXPECT_TRUE(mesh.colors.empty());
    EXPECT_THAT(notesText(), HasSubstr("note: vertex colours are not shown"));
    EXPECT_EQ(notes_.size(), 1u) << notesText();
}

TEST_F(Gltf, VertexColorsMultiplyBaseColors) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0}, "VEC4",
                  R"(,"normalized":true)");
    write(
        "m.glb",
        file.glb(fmt::format(
            R"("materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[0.5,0.25,1,1]}}}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"COLOR_0":1}},"material":0}},{{{},"material":0}}]}}],{})",
            kPositions, kNode)));
    const auto scene =
        load(write("s.toml",
                   "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[[light]]\ntype = \"point\"\nposition = "
                   "[0, 1, 2]\n[[mesh]]\nfile = \"m.glb\"\nvertex_colors = true\n"));
    EXPECT_THAT(meshOf(scene).colors,
                ElementsAre(Rgb(0.5f, 0, 0), Rgb(0, 0.25f, 0), Rgb(0, 0, 1), Rgb(0.5f, 0.25f, 1),
                            Rgb(0.5f, 0.25f, 1), Rgb(0.5f, 0.25f, 1)));
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(Gltf, PrimitivesWithoutNormalsAreFlatBesideOthers) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<float>{0, 1, 0, 0, 1, 0, 0, 0, 0}, "VEC3");
    const auto scene = read(file.embedded(fmt::format(
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}}}},{{{0}}}]}}],{1})",
        kPositions, kNode)));
    EXPECT_THAT(meshOf(scene).normals,
                ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1),
                            glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));
    EXPECT_EQ(notesText(),
              folder_.string() +
                  "/m.gltf: warning: normals that are zero, NaN or infinite; computed from the faces\n");
}

TEST_F(Gltf, NodesTransformTheirMeshes) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const auto meshAt = [&](const std::string& nodes) {
        notes_.clear();
        return meshOf(read(file.embedded(oneMesh(R"("attributes":{"POSITION":0,"NORMAL":1})", nodes))));
    };
    const std::string scene = R"(,"scenes":[{"nodes":[0]}])";
    const MeshData child = meshAt(
        R"("nodes":[{"translation":[1,2,3],"children":[1]},{"mesh":0,"scale":[2,3,4],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])" +
        scene);
    EXPECT_LT(glm::length(child.positions[1] - glm::vec3(1, 4, 3)), 1e-6f)
        << "scaled by 2, turned to y, moved";
    EXPECT_LT(glm::length(child.positions[2] - glm::vec3(-2, 2, 3)), 1e-6f);
    const MeshData matrix =
        meshAt(R"("nodes":[{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,1,1,0, 5,6,7,1]}])" + scene);
    EXPECT_EQ(matrix.positions[1], glm::vec3(6, 6, 7));
    EXPECT_LT(glm::length(matrix.normals[0] - glm::vec3(0, 0, 1)), 1e-6f)
        << "a shear along y keeps the plane of x and y";
    const MeshData mirrored = meshAt(R"("nodes":[{"mesh":0,"scale":[-1,1,1]}])" + scene);
    EXPECT_EQ(mirrored.triangles[0], glm::uvec3(0, 2, 1)) << "faces the same side";
    EXPECT_EQ(mirrored.normals[0], glm::vec3(0, 0, 1));
    const MeshData flat = meshAt(R"("nodes":[{"mesh":0,"scale":[1,1,0]}])" + scene);
    EXPECT_EQ(flat.normals[0], glm::vec3(0, 0, 1));
    EXPECT_TRUE(notes_.empty()) << notesText();
    const MeshData two =
        meshAt(R"("nodes":[{"mesh":0,"children":[1,2]},{"mesh":0},{"mesh":0,"scale":[0,0,0]}])" + scene);
    EXPECT_EQ(two.triangles.size(), 2u);
    EXPECT_THAT(notesText(), HasSubstr("scaled to zero; left out"));
}

TEST_F(Gltf, WrongIndicesAndCountsAreWarnings) {
    GltfBuilder file = triangle();
    file.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 1, 65535, 0, 1}, "SCALAR");
    file.accessor(std::vector<float>{0, 0, 1}, "VEC3");
    const auto scene = read(file.embedded(oneMesh(R"("attributes":{"POSITION":0,"NORMAL":2},"indices":1)")));
    EXPECT_EQ(meshOf(scene).triangles, Triangles{glm::uvec3(0, 1, 2)});
    EXPECT_THAT(notesText(), HasSubstr("warning: triangles with vertices that do not exist; left out"));
    EXPECT_THAT(notesText(), HasSubstr("warning: triangles whose last one has fewer than three corners"));
    EXPECT_THAT(notesText(), HasSubstr("warning: vertex attributes with another number of elements"));
}

TEST_F(Gltf, NonFiniteVerticesAreKeptAndCounted) {
    GltfBuilder file;
    file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, std::nanf(""), 0, 0, 1, INFINITY, 0, 0, 0, 0},
                  "VEC3");
    const auto scene = read(file.embedded(oneMesh(kPositions)));
    EXPECT_EQ(meshOf(scene).triangles.size(), 2u);
    EXPECT_THAT(
        notesText(),
        HasSubstr(
            "note: vertices with NaN or infinite coordinates; rays never hit their triangles (2 times)"));
    EXPECT_EQ(boundsOf(scene).upper, glm::vec3(1, 1, 0));
}

TEST_F(Gltf, ScenesUseTheMeshOnly) {
    const GltfBuilder file = triangle();
    write(
        "m.glb",
        file.glb(oneMesh(
            kPositions,
            R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],"nodes":[{"mesh":0,"camera":0}],"scenes":[{"nodes":[0]}])")));
    const auto scene = load(write("s.toml",
                                  "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[[light]]\ntype = "
                                  "\"point\"\nposition = [0, 1, 2]\n[[mesh]]\nfile = \"m.glb\"\n"));
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].lookFrom.z, 3.0f);
    EXPECT_EQ(meshOf(scene).triangles.size(), 1u);
    EXPECT_THAT(
        notesText(),
        HasSubstr(
            "m.glb: note: the cameras (1) and lights (0) of the file are ignored; a scene has its own"));
}

}  // namespace
}  // namespace rayscope::test
