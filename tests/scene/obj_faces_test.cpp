// Every form of the corners of a face.
#include <fmt/format.h>

#include "obj_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

/// Three positions, texture coordinates and normals; none of them alike.
const std::string kElements = kTriangle +
                              "vt 0.25 0\nvt 0.5 0\nvt 0.75 0\n"
                              "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";

class ObjFaces : public ObjFiles {};

struct CornerForm {
    std::string_view face;
    bool hasTexCoords, hasNormals;
};

TEST_F(ObjFaces, CornersHaveOptionalParts) {
    const CornerForm forms[] = {
        {"1 2 3", false, false},
        {"1/ 2/ 3/", false, false},
        {"1// 2// 3//", false, false},
        {"1/1 2/2 3/3", true, false},
        {"1/1/ 2/2/ 3/3/", true, false},
        {"1//1 2//2 3//3", false, true},
        {"1/1/1 2/2/2 3/3/3", true, true},
        {"-3 -2 -1", false, false},
        {"-3/-3 -2/-2 -1/-1", true, false},
        {"-3//-3 -2//-2 -1//-1", false, true},
        {"-3/-3/-3 -2/-2/-2 -1/-1/-1", true, true},
        {"1/-3/1 2/-2/2 -1/3/-1", true, true},
        {"+1/+1 +2/+2 +3/+3", true, false},
        {"001/001 2/02 3/0003", true, false},
        {"\t1/1/1 \t 2/2/2\t3/3/3 \t", true, true},
        {"1/1/1 2/2/2 3/3/3\r", true, true},
        {"1/1/1 2/2/2 3/3/3 # comment 4", true, true},
        {"1/1/1 2/2/2 3/3/3#comment", true, true},
        {"1/1/1 2/2/2 \\\n3/3/3", true, true},
    };
    for (const CornerForm& form : forms) {
        SCOPED_TRACE(form.face);
        const SceneDescription scene = read(fmt::format("{}f {}\n", kElements, form.face));
        const MeshData& mesh = meshOf(scene);
        ASSERT_EQ(mesh.triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
        EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        ASSERT_EQ(mesh.texCoords.size(), form.hasTexCoords ? 3u : 0u);
        ASSERT_EQ(mesh.normals.size(), form.hasNormals ? 3u : 0u);
        for (std::size_t i = 0; i < mesh.texCoords.size(); ++i)
            EXPECT_EQ(mesh.texCoords[i].x, 0.25f * static_cast<float>(i + 1));
        for (std::size_t i = 0; i < mesh.normals.size(); ++i)
            EXPECT_EQ(mesh.normals[i][2 - static_cast<int>(i)], 1.0f);
        EXPECT_EQ(notesText(), "");
    }
}

TEST_F(ObjFaces, WordsThatAreNoCornersAreErrorsThatQuoteThem) {
    const std::pair<std::string_view, std::string_view> words[] = {
        {"foo", ""},
        {"a", ""},
        {"1a", ""},
        {"0x3", ""},
        {"--3", ""},
        {"-", ""},
        {"+", ""},
        {"1/a/1", ""},
        {"1/1/a", ""},
        {"2:2", ""},
        {"1;", ""},
        {"1\\1", ""},
        {"nan", ""},
        {"1e0", ""},
        {"1.9", "; indices are whole numbers"},
        {"1.0", "; indices are whole numbers"},
        {"1/1.5", "; indices are whole numbers"},
        {"1,234", "; indices have no commas"},
        {"1,2,3", "; indices have no commas"},
        {"/1", "; a corner starts with the index of its position"},
        {"//1", "; a corner starts with the index of its position"},
        {"1/1/1/1", "; a corner has at most a position, a texture coordinate and a normal"},
        {"1///1", "; a corner has at most a position, a texture coordinate and a normal"},
    };
    for (const auto& [word, hint] : words) {
        EXPECT_EQ(failure(fmt::format("{}f 1 2 {}\n", kTriangle, word)),
                  fmt::format("mesh.obj:4:7: error: expected an index, got '{}'{}", word, hint));
        EXPECT_EQ(failure(fmt::format("{}f 1 2 3 {}\n", kTriangle, word)),
                  fmt::format("mesh.obj:4:9: error: expected an index, got '{}'{}", word, hint));
    }
}

TEST_F(ObjFaces, PositionsThatDoNotExistAreErrors) {
    const std::pair<std::string_view, std::string_view> indices[] = {
        {"4", ""},
        {"0", ""},
        {"-4", " so far"},
        {"2147483647", ""},
        {"2147483648", ""},
        {"4294967299", ""},
        {"-4294967299", " so far"},
        {"12345678901234567890", ""},
        {"-12345678901234567890", " so far"},
        {"99999999999999999999999999999999999999999", ""},
    };
    for (const auto& [index, when] : indices)
        for (const std::string_view rest : {"", "/1", "//1"})
            EXPECT_EQ(failure(fmt::format("{}f 1 2 {}{}\n", kTriangle, index, rest)),
                      fmt::format("mesh.obj:4:7: error: vertex {} is out of range: expected 1 to 3 or -3 to "
                                  "-1{}",
                                  index, when));
    EXPECT_EQ(failure("f 1 2 3\n"), "mesh.obj:1:3: error: vertex 1 is out of range: the file has no vertex");
    EXPECT_EQ(failure("f -1 -2 -3\n" + kTriangle),
              "mesh.obj:1:3: error: vertex -1 is out of range: the file has no vertex so far");
    EXPECT_EQ(failure("f 1 3 2\nf 1 5 2\n\nf 7 1 2\n" + kTriangle),
              "mesh.obj:2:5: error: vertex 5 is out of range: expected 1 to 3 or -3 to -1")
        << "the first one, not the largest";
}

TEST_F(ObjFaces, FacesMayPrecedeTheirElements) {
    const SceneDescription scene = read("f 1/3/1 2/2/1 3/1/1\n" + kElements);
    EXPECT_EQ(meshOf(scene).positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(meshOf(scene).texCoords[0], glm::vec2(0.75f, 0));
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjFaces, TextureCoordinatesAndNormalsThatDoNotExistAreLeftOut) {
    for (const std::string_view index : {"0", "4", "9", "-4", "-99", "4294967297", "99999999999999999999"}) {
        SCOPED_TRACE(index);
        const SceneDescription textured = read(fmt::format("{}f 1/{} 2/2 3/3\n", kElements, index));
        EXPECT_EQ(meshOf(textured).texCoords[0], glm::vec2(0.0f));
        EXPECT_EQ(meshOf(textured).texCoords[1], glm::vec2(0.5f, 0));
        EXPECT_EQ(notesText(),
                  "mesh.obj:10: warning: corners with a texture coordinate that does not exist (the file has "
                  "3); ignored\n");
        const SceneDescription smooth = read(fmt::format("{}f 1//{} 2//2 3//3\n", kElements, index));
        EXPECT_EQ(meshOf(smooth).normals[0], glm::vec3(0, 0, 1)) << "computed from the face";
        EXPECT_THAT(
            notesText(),
            HasSubstr(
                "mesh.obj:10: warning: corners with a normal that does not exist (the file has 3); ignored"));
    }
    const SceneDescription none = read(kTriangle + "f 1/1/1 2/2/2 3/3/3\nf 1/1 3/3 2/2\n");
    EXPECT_TRUE(meshOf(none).normals.empty());
    EXPECT_TRUE(meshOf(none).texCoords.empty());
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:4: warning: corners with a texture coordinate that does not "
                                       "exist (the file has 0); ignored (6 times, first here)"));
}

TEST_F(ObjFaces, FacesWithFewerThanThreeCornersAreIgnored) {
    const SceneDescription scene = read(kTriangle + "f\nf 1\nf 1// 2//\nf 1 2 3\nfo 1 3 2\n");
    EXPECT_EQ(meshOf(scene).triangles.size(), 2u) << "fo is an old name of f";
    EXPECT_EQ(notesText(),
              "mesh.obj:4: note: faces with fewer than three corners; ignored (3 times, first here)\n");
    EXPECT_EQ(failure(kTriangle + "f 1 2\n"),
              "mesh.obj: error: the file has no faces (lines 'f …') with three or more corners; the first of "
              "its 1 others is in line 4");
}

TEST_F(ObjFaces, PartsMayDifferBetweenFacesAndCorners) {
    const SceneDescription scene = read(kElements + "f 1/1/1 2/2 3//3\nf 3 2 1\n");
    const MeshData& mesh = meshOf(scene);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1)) << "computed from the face";
    EXPECT_EQ(mesh.normals[3], glm::vec3(0, 0, -1)) << "of the other face";
    EXPECT_EQ(notesText(),
              "mesh.obj: note: corners without a normal in a file with normals; computed from the faces (4 "
              "times)\n");
}

TEST_F(ObjFaces, CornersWithEqualIndicesAreShared) {
    const SceneDescription shared = read(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 -1\n"
        "f 1//1 2//1 3//1\nf 1//1 3//1 4//2\n");
    EXPECT_EQ(meshOf(shared).positions.size(), 4u);
    EXPECT_EQ(meshOf(shared).normals[3], glm::vec3(0, 0, -1));
    const SceneDescription split =
        read(kTriangle + "vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//2 3//2 2//2\n");
    EXPECT_EQ(meshOf(split).positions.size(), 6u);
}

TEST_F(ObjFaces, OnePositionMayHaveManyNormals) {
    std::string text = kTriangle;
    for (int i = 0; i < 5000; ++i) text += fmt::format("vn {} 0 1\n", i);
    for (int i = 0; i < 5000; ++i) text += fmt::format("f 1//{0} 2//{0} 3//{0}\n", i + 1);
    for (int i = 0; i < 5000; ++i) text += fmt::format("f 1//{0} 2//{0} 3//{0}\n", i + 1);
    const SceneDescription scene = read(text);
    const MeshData& mesh = meshOf(scene);
    ASSERT_EQ(mesh.positions.size(), 15000u);
    EXPECT_EQ(mesh.triangles[7500], mesh.triangles[2500]);
    EXPECT_EQ(mesh.normals[mesh.triangles[2500].x].x, 2500.0f);
}

TEST_F(ObjFaces, RepeatedCornersMakeTrianglesWithoutArea) {
    const SceneDescription scene = read(kTriangle + "f 1 2 2\nf 1 1 2 3\n");
    EXPECT_EQ(meshOf(scene).triangles.size(), 3u);
    bool isReported = false;
    for (const Diagnostic& found : lint(scene))
        isReported |= found.message.find("zero area") != std::string::npos;
    EXPECT_TRUE(isReported);
}

TEST_F(ObjFaces, PolygonsAreTriangulated) {
    const SceneDescription scene = read("v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nf 1 2 3 4\nf 1 2 3\n");
    ASSERT_EQ(meshOf(scene).triangles.size(), 3u);
    EXPECT_EQ(meshOf(scene).triangles[2], glm::uvec3(0, 1, 2));
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::uvec3 t = meshOf(scene).triangles[i];
        const auto& p = meshOf(scene).positions;
        EXPECT_GT(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).z, 0.0f)
            << "split along the axis of the arrow";
    }
}

TEST_F(ObjFaces, OutlinesThatCrossThemselvesAreWarnings) {
    read("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 2 3 4\n");
    EXPECT_EQ(
        notesText(),
        "mesh.obj:6: warning: faces whose outline crosses itself; their triangles overlap (2 times, first "
        "here)\n");
}

}  // namespace
}  // namespace rayscope::test
