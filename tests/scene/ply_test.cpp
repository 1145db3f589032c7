// The rows of PLY files: every type, ASCII and both binary orders; damaged files.
#include <random>

#include "ply_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Ply = PlyFiles;

TEST_F(Ply, BareFileIsAScene) {
    const auto scene = read(kPlyTriangle);
    EXPECT_EQ(meshOf(scene).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
    EXPECT_EQ(meshOf(scene).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(meshOf(scene).normals.empty());
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(notesText(), "");
}

TEST_F(Ply, EveryTypeInEveryFormat) {
    for (const PlyFile::Format format : PlyFile::kFormats)
        for (const std::string position :
             {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint8", "int16",
              "uint16", "int32", "uint32", "float32", "float64"})
            for (const std::string count : {"char", "uint8", "short", "uint16", "int", "uint32"})
                for (const std::string index :
                     {"int8", "uchar", "int16", "ushort", "int32", "uint", "float", "double"}) {
                    PlyFile file(format);
                    file.element("vertex", 4, {position + " x", position + " y", position + " z"});
                    file.element("face", 2, {"list " + count + " " + index + " vertex_index"});
                    file.row({{0}, {0}, {0}})
                        .row({{100}, {0}, {0}})
                        .row({{100}, {100}, {3}})
                        .row({{0}, {100}, {3}});
                    file.row({{3, 0, 1, 2}}).row({{3, 0, 2, 3}});
                    const auto scene = read(file.bytes());
                    ASSERT_EQ(meshOf(scene).positions[2], glm::vec3(100, 100, 3)) << position;
                    ASSERT_EQ(meshOf(scene).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}))
                        << count << " " << index;
                    ASSERT_EQ(notesText(), "");
                }
}

TEST_F(Ply, FacesAndIndices) {
    const std::string quad = kThree + "1 1 0\n";
    const auto polygons = read(header(4, kXyz, 4) + quad + "4 0 1 3 2\n2 0 1\n0\n1 3\n");
    EXPECT_EQ(meshOf(polygons).triangles, (std::vector<glm::uvec3>{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_THAT(
        notesText(),
        HasSubstr("mesh.ply:15: note: faces with fewer than three corners; ignored (3 times, first here)"));

    EXPECT_THAT(failure(header(3, kXyz, 2) + kThree + "3 0 1 2\n3 0 1 3\n"),
                HasSubstr("mesh.ply:14: error: vertex 3 is out of range: expected 0 to 2"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + kThree + "3 0 1 -1\n"), HasSubstr("vertex -1 is out of range"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + kThree + "3 0 1 1.5\n"), HasSubstr("index is not an integer"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + kThree + "-3 0 1 2\n"), HasSubstr("a list has the length -3"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + kThree + "3 0 1 x\n"),
                HasSubstr("mesh.ply:13:7: error: invalid number 'x'"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + "0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("mesh.ply:11:1: error: invalid number '1,5'; the decimal separator is a point"));
    EXPECT_THAT(failure(header(0, kXyz, 1) + "3 0 1 2\n"), HasSubstr("the file has no vertex"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + kThree + "2 0 1\n"),
                HasSubstr("no face has three or more corners"));
    EXPECT_EQ(meshOf(read(header(3, kXyz, 1) + kThree + "3.0 +0 1.0 2e0\n")).triangles.size(), 1u);

    for (const PlyFile::Format format : {PlyFile::Format::LittleEndian, PlyFile::Format::BigEndian}) {
        PlyFile file(format);
        file.element("vertex", 3, {"float x", "float y", "float z"})
            .element("face", 2, {"list char int vertex_index"});
        for (int i = 0; i < 3; ++i) file.row({{i * 1.0}, {i * i * 1.0}, {0}});
        PlyFile outside = file, negative = file;
        EXPECT_THAT(failure(outside.row({{3, 0, 1, 2}}).row({{3, 2, 1, 7}}).bytes()),
                    HasSubstr("mesh.ply: error: element 'face', row 2 of 2: vertex 7 is out of range"));
        EXPECT_THAT(failure(negative.row({{3, 0, 1, 2}}).row({{-3, 2, 1, 7}}).bytes()),
                    HasSubstr("row 2 of 2: a list has the length -3"));
    }
}

TEST_F(Ply, TriangleStrips) {
    for (const PlyFile::Format format : PlyFile::kFormats) {
        PlyFile file(format);
        file.element("vertex", 6, {"float x", "float y", "float z"});
        file.element("tristrips", 1, {"list int int vertex_indices"});
        for (int i = 0; i < 6; ++i) file.row({{i * 1.0}, {i % 2 * 1.0}, {0}});
        file.row({{11, 0, 1, 2, 3, 3, -1, 3, 5, 4, -1, 2}});
        EXPECT_EQ(meshOf(read(file.bytes())).triangles,
                  (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}, {3, 5, 4}}));
        EXPECT_EQ(notesText(), "");
    }
}

TEST_F(Ply, NonFinitePositionsAreNoted) {
    const std::string text = header(3, kXyz, 1) + "0 nan 0\n1 -inf 0\n0 1 1.#IND\n3 0 1 2\n";
    EXPECT_EQ(meshOf(read(text)).triangles.size(), 1u);
    EXPECT_THAT(notesText(),
                HasSubstr("mesh.ply:10: note: vertices with NaN or infinite coordinates; rays never hit "
                          "their triangles (3 times, first here)"));
}

TEST_F(Ply, LinesAndRows) {
    // Blank lines, blanks, and values behind those of the row.
    EXPECT_EQ(meshOf(read(header(3, kXyz, 1) + "\n 0\t0 0 \n\n1 0 0\n0 1 0\n3 0 1 2")).triangles.size(), 1u);
    EXPECT_EQ(notesText(), "");
    EXPECT_EQ(meshOf(read(header(3, kXyz, 1) + "0 0 0 7\n1 0 0 7\n0 1 0 7\n3 0 1 2 255 0 0\n")).positions[1],
              glm::vec3(1, 0, 0));
    EXPECT_THAT(notesText(),
                HasSubstr("mesh.ply:10: warning: lines with more values than the header announces; the "
                          "rest of them is ignored (4 times, first here)"));
    // Rows that are not lines.
    for (const std::string body : {"0 0 0 1 0 0 0 1 0 3 0 1 2", "0 0 0 1 0 0\n0 1 0 3\n0\n1\n2\n",
                                   "0 0\n0\n1 0\n0\n0 1\n0\n3\n0\n1 2\n"}) {
        const auto scene = read(header(3, kXyz, 1) + body);
        EXPECT_EQ(meshOf(scene).positions[2], glm::vec3(0, 1, 0));
        EXPECT_THAT(notesText(), HasSubstr("warning: the rows are not one per line"));
    }
    // Neither.
    EXPECT_THAT(failure(header(3, kXyz, 1) + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("mesh.ply:10:4: error: the line of a row of 'vertex' has too few values"));
    EXPECT_THAT(failure(header(3, kXyz, 1) + "0 0 0 7\n1 0 0\n0 1 0\n"),
                HasSubstr("the file ends early: it has 0 of 1 faces"));
    read(kPlyTriangle + "3 0 1 2\n");
    EXPECT_THAT(notesText(), HasSubstr("mesh.ply:14: warning: text behind the last element is ignored"));
}

TEST_F(Ply, CutFilesAndWrongCounts) {
    for (const PlyFile::Format format : PlyFile::kFormats) {
        const auto file = [&](std::uint64_t vertices, std::uint64_t faces) {
            PlyFile ply(format);
            ply.element("vertex", vertices, {"float x", "float y", "float z"});
            ply.element("face", faces, {"list uchar int vertex_indices"});
            for (int i = 0; i < 3; ++i) ply.row({{i * 1.0}, {i * i * 1.0}, {0}});
            return ply.row({{3, 0, 1, 2}}).bytes();
        };
        EXPECT_THAT(failure(file(3, 4)), HasSubstr("error: the file ends early: it has 1 of 4 faces"));
        EXPECT_THAT(failure(file(3, 1ull << 62)), HasSubstr("it has 1 of 4611686018427387904 faces"));
        EXPECT_THAT(failure(file(2000000000, 1)), HasSubstr("of 2000000000 vertices"));
        std::string trailing = file(3, 1);
        read(trailing + "abc");
        EXPECT_THAT(notesText(), HasSubstr(format == PlyFile::Format::Ascii
                                               ? "text behind the last element is ignored"
                                               : "3 bytes behind the last element are ignored"));
    }
}

TEST_F(Ply, FilesOfSeveralMegabytes) {
    constexpr int kVertices = 150000;
    for (const PlyFile::Format format : PlyFile::kFormats) {
        PlyFile file(format);
        file.element("face", kVertices - 2, {"list uchar int vertex_indices"});
        file.element("vertex", kVertices, {"float x", "float y", "double z"});
        for (int i = 0; i + 2 < kVertices; ++i) file.row({{3, i * 1.0, i + 1.0, i + 2.0}});
        for (int i = 0; i < kVertices; ++i) file.row({{i * 0.25}, {i % 7 * 1.0}, {-i * 1.0}});
        const auto scene = read(file.bytes());
        ASSERT_EQ(meshOf(scene).positions.size(), std::size_t{kVertices});
        for (std::uint32_t i = 0; i < kVertices; ++i) {
            const float x = static_cast<float>(i);
            ASSERT_EQ(meshOf(scene).positions[i], glm::vec3(0.25f * x, static_cast<float>(i % 7), -x));
            const glm::uvec3 next(i, i + 1, i + 2);
            ASSERT_TRUE(next.z >= kVertices || meshOf(scene).triangles[i] == next) << i;
        }
    }
}

TEST_F(Ply, TexturesOfMeshLab) {
    PlyFile file(PlyFile::Format::LittleEndian);
    file.comment("TextureFile the image.png").comment("TextureFile C:\\elsewhere\\other.png");
    file.element("vertex", 4, {"float x", "float y", "float z"});
    file.element("face", 2, {"list uchar int vertex_indices", "list uchar float texcoord", "int texnumber"});
    file.row({{0}, {0}, {0}}).row({{1}, {0}, {0}}).row({{1}, {1}, {0}}).row({{0}, {1}, {0}});
    file.row({{3, 0, 1, 2}, {6, 0, 0, 1, 0, 1, 1}, {1}}).row({{3, 0, 2, 3}, {6, 0, 0, 0.5, 0.5, 0, 1}, {0}});
    writeImage((folder_ / "other.png").string(), RgbImage(1, 1, Rgb(1.0f)));
    const auto scene = read(file.bytes());
    const MeshData& mesh = meshOf(scene);
    EXPECT_EQ(mesh.positions.size(), 5u) << "vertex 2 has two texture coordinates, vertex 0 one";
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.triangles[1].x, mesh.triangles[0].x);
    EXPECT_EQ(mesh.texCoords[mesh.triangles[1].y], glm::vec2(0.5f));
    EXPECT_EQ(mesh.positions[mesh.triangles[1].y], glm::vec3(1, 1, 0));
    EXPECT_EQ(mesh.materialSlots, (std::vector<std::uint16_t>{1, 0}));
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].kdTexture, nullptr);
    ASSERT_NE(scene.materials[1].kdTexture, nullptr);
    EXPECT_THAT(notesText(), HasSubstr("the image.png"));
    EXPECT_THAT(notesText(), Not(HasSubstr("other.png")));
}

TEST_F(Ply, TexturesWithoutCoordinatesAreNoted) {
    std::string text = kPlyTriangle;
    read(text.insert(text.find("element"), "comment TextureFile x.png\n"));
    EXPECT_THAT(notesText(),
                HasSubstr("note: the file names a texture, but has no texture coordinates; ignored"));
}

TEST_F(Ply, LoadingStopsOnRequest) {
    std::string text = header(3, kXyz, 30000) + kThree;
    for (int i = 0; i < 30000; ++i) text += "3 0 1 2\n";
    const std::string path = write("mesh.ply", text);
    std::stop_source source;
    double last = 0.0;
    const LoadControl control{[&](const std::string& step, double fraction) {
                                  EXPECT_EQ(step, "reading mesh.ply");
                                  EXPECT_GE(fraction, last);
                                  last = fraction;
                                  if (fraction > 0.5) source.request_stop();
                              },
                              source.get_token()};
    EXPECT_THROW(loadScene(path, notes_, control), Stopped);
    EXPECT_LT(last, 0.6);
}

/// Anything but a scene or an InputError fails the test.
TEST_F(Ply, DamagedFilesAreNeverFatal) {
    std::mt19937 random(1);
    for (const PlyFile::Format format : PlyFile::kFormats) {
        PlyFile file(format);
        file.comment("TextureFile x.png");
        file.element("vertex", 4,
                     {"float x", "double y", "short z", "float nx", "float ny", "float nz", "uchar red",
                      "uchar green", "uchar blue"});
        file.element("face", 3,
                     {"list uchar int vertex_indices", "list uchar float texcoord", "int texnumber"});
        file.element("tristrips", 1, {"list int int vertex_indices"});
        for (int i = 0; i < 4; ++i)
            file.row({{i * 1.0}, {i * i * 1.0}, {0}, {0}, {0}, {1}, {i * 80.0}, {0}, {255}});
        file.row({{3, 0, 1, 2}, {6, 0, 0, 1, 0, 1, 1}, {0}})
            .row({{4, 0, 1, 2, 3}, {0}, {1}})
            .row({{1, 0}, {0}, {0}});
        file.row({{5, 0, 1, 2, -1, 3}});
        const std::string whole = file.bytes();
        const std::string scene =
            write("scene.toml", "version = 1\n[[mesh]]\nfile = \"mesh.ply\"\nvertex_colors = true\n");
        std::size_t loaded = 0;
        const auto tryToLoad = [&](const std::string& content) {
            write("mesh.ply", content);
            loaded += errorOf(scene).empty();
        };
        for (std::size_t length = 0; length < whole.size(); ++length) tryToLoad(whole.substr(0, length));
        for (int i = 0; i < 2000; ++i) {
            std::string damaged = whole;
            damaged[random() % damaged.size()] = static_cast<char>(random());
            tryToLoad(damaged);
        }
        EXPECT_GT(loaded, 100u);
    }
}

}  // namespace
}  // namespace rayscope::test
