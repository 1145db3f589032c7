// The header of PLY files: what it may look like, what it announces, and errors in it.
#include "ply_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using PlyHeader = PlyFiles;

TEST_F(PlyHeader, HeadersAreReadAsWritten) {
    const std::string body = kThree + "3 0 1 2\n";
    const auto withLines = [](std::string text, const std::string& lineEnd) {
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += lineEnd.size())
            text.replace(at, 1, lineEnd);
        return text;
    };
    const auto with = [&](const std::string& before, const std::string& lines) {
        std::string text = kPlyTriangle;
        return text.insert(text.find(before), lines);
    };
    for (const std::string& text :
         {withLines(kPlyTriangle, "\r\n"), withLines(kPlyTriangle, "\r"),
          with("format", "comment made by hand\n"),
          with("element face", "comment\nobj_info num_cols 512\n\n"), with("end_header", "\t \n"),
          "\xef\xbb\xbf" + kPlyTriangle,
          "PLY\nFormat ASCII 1.0\nELEMENT Vertex 3\nproperty FLOAT X\nproperty float Y\n"
          "property Float32 Z\nelement  Face\t1\nProperty List UCHAR Int Vertex_Indices\nEnd_Header\n" +
              body}) {
        const auto scene = read(text);
        EXPECT_EQ(meshOf(scene).positions.size(), 3u) << text;
        EXPECT_EQ(notesText(), "") << text;
    }
}

TEST_F(PlyHeader, BinaryHeadersMayEndWithCrLf) {
    for (const std::string lineEnd : {"\n", "\r\n", "\r"}) {
        PlyFile file(PlyFile::Format::LittleEndian, lineEnd);
        file.element("vertex", 3, {"uchar x", "uchar y", "uchar z"});
        file.element("face", 1, {"list uchar uchar vertex_indices"});
        // The first byte of the data is a line feed.
        file.row({{10}, {13}, {10}}).row({{1}, {0}, {0}}).row({{0}, {1}, {0}}).row({{3, 0, 1, 2}});
        EXPECT_EQ(meshOf(read(file.bytes())).positions[0], glm::vec3(10, 13, 10));
        EXPECT_EQ(notesText(), "");
    }
}

TEST_F(PlyHeader, HeaderErrorsHaveTheirLine) {
    struct Case {
        std::string text, message;
    };
    const auto replaced = [](const std::string& from, const std::string& to) {
        std::string text = kPlyTriangle;
        return text.replace(text.find(from), from.size(), to);
    };
    const Case cases[] = {
        {"", "mesh.ply: error: the file is empty"},
        {"p", "does not begin with the line 'ply'"},
        {"plywood\n", "does not begin with the line 'ply'"},
        {"\x1f\x8b\x08" + kPlyTriangle, "gzip"},
        {std::string("\xff\xfep\0l\0y\0\n\0", 10), "UTF-16"},
        {std::string("p\0l\0y\0\n\0f\0", 10), "UTF-16"},
        {std::string("p\0\0\0l\0\0\0y\0\0\0", 12), "UTF-32"},
        {std::string("\0\0\0p\0\0\0l\0\0\0y", 12), "UTF-32"},
        {"solid x\nfacet", "is an STL file; rename it to .stl"},
        {"ply\nformat ascii 1.0\nelement vertex 3\n", "3: error: the file ends in its header"},
        {replaced("format ascii 1.0\n", ""), "no line 'format"},
        {replaced("ascii", "binary"), "mesh.ply:2: error: unknown format 'binary'"},
        {replaced("ascii", "asci"), "did you mean 'ascii'?"},
        {replaced("format ascii 1.0\n", "format ascii 1.0\nformat ascii 1.0\n"), "a second line 'format'"},
        {replaced("vertex 3", "vertex -3"), "mesh.ply:3: error: invalid number of elements '-3'"},
        {replaced("vertex 3", "vertex 3.5"), "invalid number of elements '3.5'"},
        {replaced("vertex 3", "vertex 99999999999999999999"), "invalid number of elements"},
        {replaced("vertex 3", "vertex"), "expected 'element NAME COUNT'"},
        {replaced("element vertex 3\n", ""), "mesh.ply:3: error: a property before the first element"},
        {replaced("float x", "float64bit x"), "mesh.ply:4: error: unknown type 'float64bit'"},
        {replaced("float x", "flaot x"), "did you mean 'float'?"},
        {replaced("float x", "float"), "mesh.ply:4: error: expected 'property TYPE NAME'"},
        {replaced("list uchar int", "list float int"), "mesh.ply:8: error: the length of a list"},
        {replaced("property float z\n", ""), "mesh.ply:3: error: the element 'vertex' has no property 'z'"},
        {replaced("float z", "list uchar float z"), "has no property 'z'"},
        {replaced("vertex_indices", "corners"),
         "mesh.ply:7: error: the element 'face' has no list 'vertex_ind"},
        {replaced("list uchar int vertex_indices", "int vertex_indices"), "has no list"},
        {replaced("element face 1", "element vertex 1"), "mesh.ply:7: error: a second element 'vertex'"},
        {replaced("element face", "elemnt face"),
         "unknown keyword 'elemnt' in the header (did you mean 'element'?)"},
        {replaced("element vertex", "element points"), "the header has no element 'vertex'"},
        {replaced("face 1", "face 0"), "the file has 3 points but no faces"},
        {replaced("element face 1\n" + kList, ""), "the file has 3 points but no faces"},
        {replaced("vertex 3", "vertex 3000000000"), "3000000000 vertices are more than"},
    };
    for (const Case& c : cases) EXPECT_THAT(failure(c.text), HasSubstr(c.message)) << c.text;
}

TEST_F(PlyHeader, UnknownLinesAreIgnoredWithAWarning) {
    std::string text = kPlyTriangle;
    read(text.insert(text.find("element"), "Created by a program, source file:\n3\n"));
    EXPECT_THAT(notesText(), HasSubstr("mesh.ply:3: warning: header lines that begin with no keyword of PLY; "
                                       "ignored (2 times, first here)"));
}

TEST_F(PlyHeader, OtherVersionsAreReadWithAWarning) {
    for (const std::string version : {"ascii 2.0", "ascii"}) {
        std::string text = kPlyTriangle;
        read(text.replace(text.find("ascii 1.0"), 9, version));
        EXPECT_THAT(notesText(), HasSubstr("mesh.ply:2: warning: the version of the format is not 1.0"));
    }
}

TEST_F(PlyHeader, ElementsAndPropertiesInAnyOrder) {
    for (const PlyFile::Format format : PlyFile::kFormats) {
        PlyFile file(format);
        file.element("camera", 1, {"float view", "list uchar double matrix"});
        file.element("face", 2, {"uchar flags", "list int uint vertex_indices", "list uchar short scalars"});
        file.element("edge", 2, {"int vertex1", "int vertex2"});
        file.element("nothing", 7, {});
        file.element("vertex", 5,
                     {"double z", "list ushort float weights", "float quality", "float y", "short x"});
        file.row({{7}, {3, 1, 2, 3}});
        // A concave quadrilateral before its vertices.
        file.row({{255}, {4, 0, 1, 2, 3}, {0}}).row({{0}, {3, 1, 4, 2}, {2, -5, 7}});
        file.row({{0}, {1}}).row({{1}, {2}});
        file.row({{0}, {0}, {9}, {0}, {0}})
            .row({{0}, {1, 5}, {9}, {-1}, {2}})
            .row({{0}, {2, 5, 6}, {9}, {0}, {1}});
        file.row({{0}, {0}, {9}, {1}, {2}}).row({{4}, {0}, {9}, {0}, {3}});
        const auto scene = read(file.bytes());
        const MeshData& mesh = meshOf(scene);
        EXPECT_EQ(mesh.positions[4], glm::vec3(3, 0, 4));
        ASSERT_EQ(mesh.triangles.size(), 3u);
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::uvec3 t = mesh.triangles[i];
            const auto& p = mesh.positions;
            EXPECT_GT(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).z, 0.0f) << "split at the concave corner";
        }
        EXPECT_EQ(mesh.triangles[2], glm::uvec3(1, 4, 2));
        EXPECT_EQ(notesText(), folder_.string() +
                                   "/mesh.ply: note: ignored elements: camera, edge, nothing\n" +
                                   folder_.string() +
                                   "/mesh.ply: note: ignored properties: flags of face, quality of vertex, "
                                   "scalars of face, weights of vertex\n");
    }
}

TEST_F(PlyHeader, NormalsAndTextureCoordinates) {
    const std::string names[][2] = {
        {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
    for (const auto& [u, v] : names)
        for (const PlyFile::Format format : PlyFile::kFormats) {
            PlyFile file(format);
            file.element("vertex", 3,
                         {"float x", "float y", "float z", "float nx", "double ny", "float nz", "float " + u,
                          "float " + v});
            file.element("face", 1, {"list uchar int vertex_indices"});
            for (int i = 0; i < 3; ++i)
                file.row(
                    {{i == 1 ? 1.0 : 0.0}, {i == 2 ? 1.0 : 0.0}, {0}, {0}, {0.5}, {1}, {0.25}, {i * 0.5}});
            file.row({{3, 0, 1, 2}});
            const auto scene = read(file.bytes());
            EXPECT_EQ(meshOf(scene).normals[1], glm::vec3(0, 0.5f, 1));
            EXPECT_EQ(meshOf(scene).texCoords[2], glm::vec2(0.25f, 1.0f));
            EXPECT_EQ(notesText(), "");
        }
}

TEST_F(PlyHeader, IncompleteAttributesAreIgnoredWithAWarning) {
    const auto scene = read(header(3, kXyz + "property float nx\nproperty float s\nproperty uchar red\n", 1) +
                            "0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n");
    EXPECT_TRUE(meshOf(scene).normals.empty());
    EXPECT_TRUE(meshOf(scene).texCoords.empty());
    for (const std::string what : {"normals with fewer than 3 components; ignored",
                                   "texture coordinates with fewer than 2 components; ignored",
                                   "vertex colours with fewer than 3 components; ignored"})
        EXPECT_THAT(notesText(), HasSubstr("mesh.ply:3: warning: " + what));
}

TEST_F(PlyHeader, TheFirstOfTwoEqualPropertiesIsUsed) {
    const auto scene =
        read(header(3, kXyz + "property float x\n", 1) + "0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n");
    EXPECT_EQ(meshOf(scene).positions[1], glm::vec3(1, 0, 0));
    EXPECT_THAT(notesText(), HasSubstr("mesh.ply:7: warning: a second property for the same purpose, 'x'"));
}

}  // namespace
}  // namespace rayscope::test
