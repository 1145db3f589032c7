// OBJ and MTL files as programs write them.
#include "scene_files.h"

#include <fmt/format.h>
#include <rayscope/image.h>
#include <clocale>
#include <locale>

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ObjReader : public SceneFiles {
  protected:
    SceneDescription read(const std::string& text) { return load(write("mesh.obj", text)); }
    std::string failure(const std::string& text) { return errorOf(write("mesh.obj", text)); }
    static const MeshData& meshOf(const SceneDescription& scene) { return *scene.meshes.at(0).data; }
};

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(ObjReader, BareMeshGetsACameraAndALight) {
    const auto scene = read(kTriangle + "f 1 2 3\n");
    EXPECT_EQ(meshOf(scene).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
    ASSERT_EQ(scene.cameras.size(), 1u);
    ASSERT_EQ(scene.lights.size(), 1u);
    const CameraDescription& camera = scene.cameras[0];
    const glm::vec3 toLight = std::get<PointLight>(scene.lights[0].shape).position - camera.lookFrom;
    EXPECT_LT(toLight.x, 0.0f) << "left of a camera that looks along -z";
    EXPECT_GT(toLight.y, 0.0f) << "above it";
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(ObjReader, CornersWithEqualIndicesAreShared) {
    const auto scene =
        read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//1 3//1 4//2\n");
    EXPECT_EQ(meshOf(scene).positions.size(), 4u);
    EXPECT_EQ(meshOf(scene).normals[3], glm::vec3(0, 0, -1));
    const auto split = read(kTriangle + "vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1\nf 1//2 3//2 2//2\n");
    EXPECT_EQ(meshOf(split).positions.size(), 6u);
}

TEST_F(ObjReader, PolygonsAreTriangulated) {
    const auto scene = read("v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nf 1 2 3 4\nf 1 2 3\n");
    ASSERT_EQ(meshOf(scene).triangles.size(), 3u);
    EXPECT_EQ(meshOf(scene).triangles[2], glm::uvec3(0, 1, 2));
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::uvec3 t = meshOf(scene).triangles[i];
        const auto& p = meshOf(scene).positions;
        EXPECT_GT(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).z, 0.0f)
            << "split along the axis of the arrow";
    }
}

TEST_F(ObjReader, NegativeIndicesCountBack) {
    const auto scene = read("v 9 9 9\n" + kTriangle + "f -3 -2 -1\n");
    EXPECT_EQ(meshOf(scene).positions[0], glm::vec3(0, 0, 0));
    EXPECT_EQ(meshOf(scene).positions[1], glm::vec3(1, 0, 0));
}

TEST_F(ObjReader, FacesMayPrecedeTheirVertices) {
    EXPECT_EQ(meshOf(read("f 1 2 3\n" + kTriangle)).positions[1], glm::vec3(1, 0, 0));
}

TEST_F(ObjReader, ReadsWindowsFilesWithByteOrderMarkAndContinuedLines) {
    const auto scene = read("\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\r\nv 0 1 \\\r\n 0.5\r\n\r\n  f 1 2 \\\r\n3\r\n");
    EXPECT_EQ(meshOf(scene).positions[2], glm::vec3(0, 1, 0.5f));
    EXPECT_EQ(meshOf(scene).triangles.size(), 1u);
}

TEST_F(ObjReader, TextureCoordinatesAndMixedNormals) {
    const auto scene = read(kTriangle + "vt 0.5\nvt 0 1 0\nvn 0 1 0\nf 1/1/1 2/2 3/2\n");
    EXPECT_EQ(meshOf(scene).texCoords[0], glm::vec2(0.5f, 0));
    EXPECT_EQ(meshOf(scene).texCoords[1], glm::vec2(0, 1));
    EXPECT_EQ(meshOf(scene).normals[0], glm::vec3(0, 1, 0));
    EXPECT_EQ(meshOf(scene).normals[1], glm::vec3(0, 0, 1)) << "computed from the face";
    EXPECT_TRUE(meshOf(read(kTriangle + "f 1 2 3\n")).normals.empty());
}

TEST_F(ObjReader, IndicesOutOfRangeAreErrorsWithTheLine) {
    EXPECT_EQ(failure(kTriangle + "f 1 2 3\nf 1 2 4\n"),
              "mesh.obj:5: error: vertex 4 is out of range: expected 1 to 3 or -3 to -1");
    EXPECT_EQ(failure(kTriangle + "f 0 1 2\n"),
              "mesh.obj:4: error: vertex 0 is out of range: expected 1 to 3 or -3 to -1");
    EXPECT_EQ(failure(kTriangle + "f 1 2 -4\n"),
              "mesh.obj:4: error: vertex -4 is out of range: expected 1 to 3 or -3 to -1");
    EXPECT_EQ(failure(kTriangle + "f 1//1 2//1 3//1\n"),
              "mesh.obj:4: error: normal 1 is out of range: the file has no normal");
    EXPECT_EQ(failure(kTriangle + "f a b c\n"),
              "mesh.obj:4: error: vertex 0 is out of range: expected 1 to 3 or -3 to -1");
}

TEST_F(ObjReader, IndicesBeyondIntAreErrors) {
    EXPECT_EQ(failure(kTriangle + "f 1 2 4294967299\n"),
              "mesh.obj:4: error: an index has more than nine digits");
}

TEST_F(ObjReader, CommentsAreIgnored) {
    const auto scene = read("# a path C:\\\nv 0 0 0 # origin\r\nv 1 0 0\nv 0 1 0#\nf 1 2 3 # 4 5\n");
    EXPECT_EQ(meshOf(scene).positions.size(), 3u);
    EXPECT_EQ(meshOf(scene).triangles.size(), 1u);
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(ObjReader, FilesWithoutFacesAreErrors) {
    EXPECT_EQ(failure(""), "mesh.obj: error: the file has no faces (lines 'f …')");
    EXPECT_EQ(failure(kTriangle), "mesh.obj: error: the file has no faces (lines 'f …')");
}

TEST_F(ObjReader, InvalidNumbersAreErrors) {
    EXPECT_EQ(failure("v 0 zero 0\n"), "mesh.obj:1: error: expected a number, got 'zero 0'");
    EXPECT_EQ(failure("v 0 0 # end\n"), "mesh.obj:1: error: expected 3 numbers, got 2");
}

TEST_F(ObjReader, NonFiniteVerticesAreKeptAndCounted) {
    const auto scene =
        read("v 0 0 0\nv nan 0 0\nv 0 -inf 0\nv 1 1 1e60\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 4 5\nf 1 5 6\n");
    EXPECT_TRUE(std::isnan(meshOf(scene).positions[1].x));
    EXPECT_TRUE(std::isinf(meshOf(scene).positions[2].y));
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:2: note: 3 vertices with NaN or infinite coordinates"));
    EXPECT_EQ(boundsOf(scene).upper, glm::vec3(1, 1, 0)) << "bounds of the finite vertices";
}

TEST_F(ObjReader, DegenerateFacesAndUnknownStatementsAreNotedOnce) {
    const auto scene = read(kTriangle + "f 1 2\nl 1 2\nl 2 3\nf 1\nf 1 2 3\n");
    EXPECT_EQ(meshOf(scene).triangles.size(), 1u);
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:4: note: 2 faces with fewer than three vertices"));
    EXPECT_THAT(notesText(), HasSubstr("ignored statements: l\n"));
    EXPECT_EQ(notes_.size(), 2u);
}

TEST_F(ObjReader, ReadsMaterials) {
    write("lib/a b.mtl",
          "newmtl red paint\nKd 0.5 0.1 0.1\nKs 0.25 0.25 0.25\nNs 30\nTr 0.25\nillum 3\nKa 1 1 1\nmap_bump "
          "x.png\n"
          "newmtl blue\nKd 0 0 1\nd 0.5\nTr 0.75\n");
    const auto scene = read("mtllib lib\\a b.mtl\n" + kTriangle +
                            "usemtl red paint  \nf 1 2 3\nusemtl blue\nf 1 2 3\nf 1 3 2\n");
    ASSERT_EQ(scene.materials.size(), 2u);
    const Material& red = scene.materials[0];
    EXPECT_EQ(red.name, "red paint");
    EXPECT_EQ(red.kd, Rgb(0.5f, 0.1f, 0.1f));
    EXPECT_EQ(red.ks, Rgb(0.25f));
    EXPECT_EQ(red.shininess, 30.0f);
    EXPECT_EQ(red.opacity, 0.75f);
    EXPECT_EQ(red.illum, 3);
    EXPECT_EQ(scene.materials[1].opacity, 0.5f) << "d overrides Tr";
    EXPECT_EQ(meshOf(scene).materialSlots, (std::vector<std::uint16_t>{0, 1, 1}));
    EXPECT_THAT(notesText(), HasSubstr("d 0.5 contradicts Tr 0.75; d is used"));
    EXPECT_THAT(notesText(), HasSubstr("ignored statements: Ka, map_bump"));
}

TEST_F(ObjReader, FacesBeforeTheFirstUsemtlHaveADefaultMaterial) {
    write("m.mtl", "newmtl a\nKd 1 0 0\n");
    const auto scene = read("mtllib m.mtl\n" + kTriangle + "f 1 2 3\nusemtl a\nf 1 2 3\n");
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, "default");
    EXPECT_EQ(meshOf(scene).materialSlots, (std::vector<std::uint16_t>{0, 1}));
}

TEST_F(ObjReader, TexturePathsMayHaveOptionsAndBackslashes) {
    const std::string image = (folder_ / "images" / "a.pfm").string();
    std::filesystem::create_directories(folder_ / "images");
    RgbImage texels(2, 1);
    texels.at(0, 0) = Rgb(1, 0, 0);
    writeImage(image, texels);
    write("m.mtl", "newmtl a\nKd 0 0 0\nmap_Kd -clamp on -mm 0 1 -blendu on images\\a.pfm\n");
    const auto scene = read("mtllib m.mtl\nusemtl a\n" + kTriangle + "f 1 2 3\n");
    ASSERT_TRUE(scene.materials[0].kdTexture) << notesText();
    EXPECT_EQ(scene.materials[0].kdTexture->image.at(0, 0), Rgb(1, 0, 0));
    EXPECT_EQ(scene.materials[0].kdTexture->wrap, TextureWrap::Clamp);
}

TEST_F(ObjReader, MissingMaterialsAndTexturesAreWarnings) {
    const auto plain = read("mtllib gone.mtl\nusemtl a\n" + kTriangle + "f 1 2 3\n");
    EXPECT_EQ(plain.materials.size(), 1u);
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:1: warning: material file not found: "));
    EXPECT_EQ(notes_.size(), 1u);

    notes_.clear();
    write("m.mtl", "newmtl a\nKd 0.5 0.5 0.5\nmap_Kd gone.png\nnewmtl b\nmap_Kd gone.png\n");
    write("empty.png", "");
    const auto textured = read("mtllib m.mtl\nusemtl a\n" + kTriangle + "f 1 2 3\n");
    EXPECT_FALSE(textured.materials[0].kdTexture);
    EXPECT_EQ(textured.materials[0].kd, Rgb(0.5f));
    EXPECT_EQ(notes_.size(), 1u) << notesText();
    EXPECT_THAT(notesText(), HasSubstr("gone.png"));

    notes_.clear();
    read("mtllib m.mtl\nusemtl c\n" + kTriangle + "f 1 2 3\n");
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:2: warning: undefined material 'c'"));
}

TEST_F(ObjReader, DoesNotDependOnTheLocale) {
    // A locale of C++ needs no installed one; the C locale is changed too, where one is installed.
    struct CommaPoint : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const char* before = std::setlocale(LC_ALL, nullptr);
    const std::string saved = before ? before : "C";
    const std::locale savedGlobal = std::locale::global(std::locale(std::locale(), new CommaPoint));
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);
    const auto scene = read("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::locale::global(savedGlobal);
    std::setlocale(LC_ALL, saved.c_str());
    EXPECT_EQ(meshOf(scene).positions[0].x, 0.5f);
}

TEST_F(ObjReader, ReadsThousandsOfVertices) {
    std::string text;
    for (int i = 0; i < 2000; ++i) text += fmt::format("v {} {} 0\n", i % 50, i / 50);
    for (int i = 0; i + 51 < 2000; ++i) text += fmt::format("f {} {} {}\n", i + 1, i + 2, i + 52);
    const auto scene = read(text);
    EXPECT_EQ(meshOf(scene).triangles.size(), 1949u);
    for (const glm::uvec3& t : meshOf(scene).triangles) {
        EXPECT_EQ(meshOf(scene).positions[t.y] - meshOf(scene).positions[t.x] != glm::vec3(0.0f), true);
        EXPECT_LT(std::max({t.x, t.y, t.z}), meshOf(scene).positions.size());
    }
    EXPECT_EQ(meshOf(scene).positions.size(), 2000u);
}

}  // namespace
}  // namespace rayscope::test
