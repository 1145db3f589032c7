// Colours of vertices: from the file to the description.
#include "image/srgb.h"
#include "ply_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class VertexColors : public SceneFiles {
  protected:
    /// A triangle whose corners have the colours (low, 0, high), (0, high, 0), (low, low, low).
    void writeTriangle(PlyFile::Format format, const std::string& type, double low, double high,
                       const std::array<std::string, 3>& names = {"red", "green", "blue"}) {
        PlyFile file(format);
        file.element("vertex", 3,
                     {"float x", "float y", "float z", type + " " + names[0], type + " " + names[1],
                      type + " " + names[2], "uchar alpha"});
        file.element("face", 1, {"list uchar int vertex_indices"});
        file.row({{0}, {0}, {0}, {low}, {0}, {high}, {255}});
        file.row({{1}, {0}, {0}, {0}, {high}, {0}, {255}});
        file.row({{0}, {1}, {0}, {low}, {low}, {low}, {255}});
        file.row({{3, 0, 1, 2}});
        write("mesh.ply", file.bytes());
    }
    SceneDescription loadMesh(const std::string& keys) {
        notes_.clear();
        return load(write("scene.toml",
                          "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[[light]]\ntype = \"point\"\n"
                          "position = [0, 0, 3]\n[[mesh]]\nfile = \"mesh.ply\"\n" +
                              keys));
    }
    const std::string kShown = "vertex_colors = true\n";
    const std::string kNote =
        "note: vertex colours are not shown; vertex_colors = true in [[mesh]] shows them";
};

TEST_F(VertexColors, EveryTypeIsDecodedFromSrgb) {
    struct Case {
        std::string type;
        double low, high;
        float linearLow;
    };
    const Case cases[] = {{"uchar", 51, 255, image::decodeByte(51)},
                          {"uint8", 51, 255, image::decodeByte(51)},
                          {"ushort", 13107, 65535, image::srgbToLinear(0.2f)},
                          {"float", 0.2, 1, image::srgbToLinear(0.2f)},
                          {"double", 0.2, 1, image::srgbToLinear(0.2f)}};
    for (const PlyFile::Format format : PlyFile::kFormats)
        for (const Case& c : cases) {
            writeTriangle(format, c.type, c.low, c.high);
            const auto scene = loadMesh(kShown);
            const std::vector<Rgb>& colors = scene.meshes[0].data->colors;
            ASSERT_EQ(colors.size(), 3u);
            EXPECT_NEAR(colors[0].r, c.linearLow, 1e-6f) << c.type;
            EXPECT_EQ(colors[0].b, 1.0f);
            EXPECT_EQ(colors[1], Rgb(0, 1, 0));
            EXPECT_TRUE(scene.meshes[0].vertexColors);
            EXPECT_THAT(notesText(), Not(HasSubstr("colours")));
            EXPECT_TRUE(requirementsOf(scene).vertexColors);
        }
}

TEST_F(VertexColors, EveryName) {
    const std::array<std::string, 3> names[] = {
        {"r", "g", "b"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}, {"Red", "Green", "Blue"}};
    for (const auto& name : names) {
        writeTriangle(PlyFile::Format::Ascii, "uchar", 51, 255, name);
        EXPECT_EQ(loadMesh(kShown).meshes[0].data->colors.size(), 3u) << name[0];
    }
}

TEST_F(VertexColors, ColoursThatAreNotShownAreNotStored) {
    writeTriangle(PlyFile::Format::LittleEndian, "uchar", 51, 255);
    for (const std::string keys : {"", "vertex_colors = false\n"}) {
        const auto scene = loadMesh(keys);
        EXPECT_TRUE(scene.meshes[0].data->colors.empty());
        EXPECT_FALSE(requirementsOf(scene).vertexColors);
        EXPECT_THAT(notesText(), HasSubstr("mesh.ply:7: " + kNote));
    }
    notes_.clear();
    const auto bare = load((folder_ / "mesh.ply").string());
    EXPECT_TRUE(bare.meshes[0].data->colors.empty());
    EXPECT_THAT(notesText(), HasSubstr(kNote));
}

TEST_F(VertexColors, InstancesDecideForThemselves) {
    writeTriangle(PlyFile::Format::LittleEndian, "uchar", 51, 255);
    const auto scene = loadMesh("[[mesh]]\nfile = \"mesh.ply\"\n" + kShown);
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].data, scene.meshes[1].data);
    EXPECT_FALSE(scene.meshes[0].vertexColors);
    EXPECT_TRUE(scene.meshes[1].vertexColors);
    EXPECT_THAT(notesText(), Not(HasSubstr("not shown")));
}

TEST_F(VertexColors, MeshesWithoutColoursGetAWarning) {
    write("mesh.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
          "3 0 1 2\n");
    EXPECT_FALSE(requirementsOf(loadMesh(kShown)).vertexColors);
    EXPECT_THAT(notesText(), HasSubstr("scene.toml:9:17: warning: mesh 'mesh.ply' has no vertex colours"));
    const std::string generated =
        write("generated.toml", "version = 1\n[[mesh]]\ngenerate = { shape = \"quad\" }\n" + kShown);
    load(generated);
    EXPECT_THAT(notesText(), HasSubstr("generated.toml:4:17: warning: mesh 'mesh 1' has no vertex colours"));
    EXPECT_THAT(
        errorOf(write("scene.toml", "version = 1\n[[mesh]]\nfile = \"mesh.ply\"\nvertex_colors = 1\n")),
        HasSubstr("scene.toml:4:17: error:"));
}

TEST_F(VertexColors, ValuesOutsideTheRangeAreClamped) {
    writeTriangle(PlyFile::Format::Ascii, "float", -0.5, 255);
    const auto scene = loadMesh(kShown);
    EXPECT_EQ(scene.meshes[0].data->colors[0], Rgb(0, 0, 1));
    EXPECT_THAT(notesText(),
                HasSubstr("mesh.ply:14: warning: vertex colours outside of their range; clamped (3 times, "
                          "first here)"));
    writeTriangle(PlyFile::Format::Ascii, "uchar", 300, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(loadMesh(kShown).meshes[0].data->colors[0], Rgb(1, 0, 0));
}

TEST_F(VertexColors, TypesWithoutARangeAreIgnored) {
    for (const std::string type : {"char", "short", "int", "uint"}) {
        writeTriangle(PlyFile::Format::BigEndian, type, 51, 100);
        EXPECT_TRUE(loadMesh(kShown).meshes[0].data->colors.empty());
        EXPECT_THAT(notesText(),
                    HasSubstr("mesh.ply:7: warning: vertex colours of a type without a usual range"));
    }
}

TEST_F(VertexColors, LintChecksThemForEnergy) {
    writeTriangle(PlyFile::Format::Ascii, "uchar", 51, 255);
    const auto scene =
        loadMesh(kShown + "material = \"m\"\n[material.m]\nkd = [0, 0, 0]\nks = [0.5, 0.5, 0.5]\n");
    std::string found;
    for (const Diagnostic& diagnostic : lint(scene)) found += toString(diagnostic) + "\n";
    EXPECT_THAT(found, HasSubstr("mesh 'mesh.ply' is not energy-conserving: vertex colour + ks = 1.5"));
}

}  // namespace
}  // namespace rayscope::test
