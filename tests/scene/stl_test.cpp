// STL files: ASCII and binary, and how they are told apart; damaged files.
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Stl : public SceneFiles {
  protected:
    SceneDescription read(std::string_view content) {
        notes_.clear();
        return load(write("mesh.stl", content));
    }
    std::string failure(std::string_view content) { return errorOf(write("mesh.stl", content)); }
    static const MeshData& meshOf(const SceneDescription& scene) { return *scene.meshes.at(0).data; }
};

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::string bytesOf(std::uint32_t value, int count = 4) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i)));
    return bytes;
}

/// A facet of a binary file.
std::string facet(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                  const glm::vec3& normal = glm::vec3(0), std::uint32_t attribute = 0) {
    std::string bytes;
    for (const glm::vec3& v : {normal, a, b, c})
        for (int i = 0; i < 3; ++i) bytes += bytesOf(std::bit_cast<std::uint32_t>(v[i]));
    return bytes + bytesOf(attribute, 2);
}

std::string binary(std::uint32_t count, const std::string& facets, std::string head = "made by a program") {
    head.resize(80, ' ');
    return head + bytesOf(count) + facets;
}

const glm::vec3 kA(0), kB(1, 0, 0), kC(1, 1, 0), kD(0, 1, 0);
const std::string kQuad = facet(kA, kB, kC, {0, 0, 1}) + facet(kA, kC, kD, {0, 0, 1});
const std::string kLoop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string kAscii = "solid part\nfacet normal 0 0 1\n" + kLoop + "endsolid part\n";

TEST_F(Stl, BinaryFilesShareCorners) {
    const auto scene = read(binary(2, kQuad));
    EXPECT_EQ(meshOf(scene).positions, (std::vector<glm::vec3>{kA, kB, kC, kD}));
    EXPECT_EQ(meshOf(scene).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(meshOf(scene).normals.empty()) << "flat shading";
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(notesText(), "");
}

TEST_F(Stl, ManyCornersAreShared) {
    std::string facets;
    constexpr int kSide = 60;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const glm::vec3 at(x, y, 0);
            facets += facet(at, at + kB, at + kC) + facet(at, at + kC, at + kD);
        }
    const auto scene = read(binary(2 * kSide * kSide, facets));
    ASSERT_EQ(meshOf(scene).triangles.size(), std::size_t{2 * kSide * kSide});
    EXPECT_EQ(meshOf(scene).positions.size(), std::size_t{(kSide + 1) * (kSide + 1)});
    for (std::size_t i = 0; i < meshOf(scene).triangles.size(); ++i) {
        const glm::vec3 at(static_cast<float>(i / 2 % kSide), static_cast<float>(i / 2 / kSide), 0);
        const glm::uvec3 t = meshOf(scene).triangles[i];
        ASSERT_EQ(meshOf(scene).positions[t.x], at);
        ASSERT_EQ(meshOf(scene).positions[t.z], at + (i % 2 == 0 ? kC : kD));
    }
}

TEST_F(Stl, BinaryFilesMayBeginWithSolid) {
    for (const std::string head : {"solid", "solid ascii", "SOLID x\nfacet normal"}) {
        EXPECT_EQ(meshOf(read(binary(2, kQuad, head))).triangles.size(), 2u);
        EXPECT_EQ(notesText(), "");
    }
    EXPECT_EQ(meshOf(read(binary(2, kQuad + "abc", "solid"))).triangles.size(), 2u);
    EXPECT_THAT(notesText(), HasSubstr("warning: 3 bytes behind the last facet are ignored"));
    EXPECT_EQ(meshOf(read(binary(9, kQuad, std::string("solid\0", 6)))).triangles.size(), 2u);
}

TEST_F(Stl, WrongCountsOfBinaryFiles) {
    struct Case {
        std::uint32_t count;
        std::string tail, message;
        std::size_t triangles;
    };
    const Case cases[] = {
        {1, "", "warning: 50 bytes behind the last facet are ignored", 1},
        {2, "0123456789", "warning: 10 bytes behind the last facet are ignored", 2},
        {3, "", "warning: the header announces 3 facets, but the file has 2", 2},
        {3, "cut", "warning: the header announces 3 facets, but the file has 2", 2},
        {0xffffffffu, "", "warning: the header announces 4294967295 facets, but the file has 2", 2},
        {0, "", "warning: the header announces 0 facets, but the file has 2", 2}};
    for (const Case& c : cases) {
        EXPECT_EQ(meshOf(read(binary(c.count, kQuad + c.tail))).triangles.size(), c.triangles) << c.message;
        EXPECT_THAT(notesText(), HasSubstr("mesh.stl: " + c.message));
    }
    EXPECT_THAT(failure(binary(0, "")), HasSubstr("mesh.stl: error: the file has no facets"));
}

TEST_F(Stl, OtherFilesAreRefusedByName) {
    std::mt19937 random(1);
    std::string noise(3000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    struct Case {
        std::string text, message;
    };
    const Case cases[] = {
        {"", "mesh.stl: error: the file is empty"},
        {noise, "neither begins with the word 'solid' nor holds binary facets"},
        {std::string(500, '\0').substr(0, 60), "neither begins"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "neither begins"},
        {"ply\nformat ascii 1.0\n", "is a PLY file; rename it to .ply"},
        {"\x1f\x8b\x08" + noise, "gzip"},
        {std::string("PK\x03\x04") + std::string(400, '\0'), "ZIP"},
        {std::string("s\0o\0l\0i\0d\0 \0x\0\n\0", 16) + std::string(400, '\0'), "UTF-16"},
        {"\xff\xfes" + std::string(400, '\0'), "UTF-16"},
        {std::string("\xff\xfe\0\0s\0\0\0", 8), "UTF-32"},
    };
    for (const Case& c : cases) EXPECT_THAT(failure(c.text), HasSubstr(c.message));
}

TEST_F(Stl, AsciiFiles) {
    const auto scene = read(kAscii);
    EXPECT_EQ(meshOf(scene).positions, (std::vector<glm::vec3>{kA, kB, kD}));
    EXPECT_EQ(meshOf(scene).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
    EXPECT_EQ(notesText(), "");
    std::string upper = kAscii;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    std::string crLf = kAscii, cr = kAscii;
    for (std::size_t at = 0; (at = crLf.find('\n', at)) != std::string::npos; at += 2)
        crLf.replace(at, 1, "\r\n");
    for (char& c : cr) c = c == '\n' ? '\r' : c;
    const std::string facets = "facet normal 0 0 1\n" + kLoop;
    for (const std::string& text :
         {upper, crLf, cr, "\xef\xbb\xbf" + kAscii, "\n  \t" + kAscii, "solid\n" + facets + "endsolid",
          "solid a facet of vertex 1 2 3\n" + facets + "endsolid with another name\n\n",
          std::string(
              "solid x\nFacet Normal 0 0 1 Outer Loop Vertex 0 0 0\nVERTEX 1 0 0 vertex\n0 1 0 EndLoop "
              "EndFacet EndSolid"),
          "solid x\n facet normal nan -nan(ind) 1.#QNAN\n" + kLoop + "endsolid x\n"}) {
        EXPECT_EQ(meshOf(read(text)).triangles.size(), 1u) << text;
        EXPECT_EQ(notesText(), "") << text;
    }
}

TEST_F(Stl, OddAsciiFiles) {
    struct Case {
        std::string text, message;
    };
    const std::string facets = "facet normal 0 0 1\n" + kLoop;
    const Case cases[] = {
        {"solid x\n" + facets, "mesh.stl:9: warning: the file ends without 'endsolid'"},
        {kAscii + kAscii, "mesh.stl:10: note: several solids are read as one mesh"},
        {"solid x\n" + facets + "solid y\nendsolid y\n",
         "mesh.stl:9: warning: a solid begins before the 'endsolid' of the last one"},
        {"solid x\nfacet\n" + kLoop + "endsolid\n", "mesh.stl:2: note: facets without a normal"},
        {"solid x\nfacet normal 0 0 -1\n" + kLoop + facets + "facet normal 0 0 -2\n" + kLoop + "endsolid\n",
         "mesh.stl:2: note: normals of facets that disagree with the order of the corners; the order is used "
         "(2 "
         "times, first here)"},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 1 0 "
         "0\nendloop\nendfacet\n" +
             facets + "endsolid\n",
         "mesh.stl:2: note: degenerate facets (two corners are equal); rays never hit them"},
        {"solid x\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 0 inf 0\nvertex 1 0 "
         "0\nendloop\nendfacet\n" +
             facets + "endsolid\n",
         "mesh.stl:2: note: vertices with NaN or infinite coordinates; rays never hit their triangles (2 "
         "times"},
    };
    for (const Case& c : cases) {
        EXPECT_FALSE(meshOf(read(c.text)).triangles.empty());
        EXPECT_THAT(notesText(), HasSubstr(c.message));
    }
}

TEST_F(Stl, AsciiErrorsHaveTheirPosition) {
    const auto replaced = [](const std::string& from, const std::string& to) {
        std::string text = kAscii;
        return text.replace(text.find(from), from.size(), to);
    };
    struct Case {
        std::string text, message;
    };
    const Case cases[] = {
        {"solid x\nendsolid x\n", "mesh.stl: error: the file has no facets"},
        {"solid", "the file has no facets"},
        {replaced("facet normal", "facets normal"),
         "mesh.stl:2:1: error: expected 'facet' or 'endsolid', got 'facets'"},
        {replaced("facet normal 0 0 1", "facet normal 0 0"),
         "mesh.stl:3:1: error: expected a number, got 'outer'"},
        {replaced("facet normal", "facet nrm"), "mesh.stl:2:7: error: expected 'outer loop', got 'nrm'"},
        {replaced("outer loop", "outer"), "mesh.stl:4:1: error: expected 'loop', got 'vertex'"},
        {replaced("vertex 1 0 0", "vertx 1 0 0"), "mesh.stl:5:1: error: expected 'vertex', got 'vertx'"},
        {replaced("vertex 1 0 0", "vertex 1 zero 0"), "mesh.stl:5:10: error: expected a number, got 'zero'"},
        {replaced("vertex 1 0 0", "vertex 1,5 0 0"),
         "mesh.stl:5:8: error: expected a number with a decimal point, got '1,5'"},
        {replaced("vertex 1 0 0\n", ""), "mesh.stl:6:1: error: expected 'vertex', got 'endloop'"},
        {replaced("endloop", "vertex 3 3 3\nendloop"),
         "mesh.stl:7:1: error: a facet with more than three corners"},
        {replaced("endfacet\n", ""), "mesh.stl:8:1: error: expected 'endfacet', got 'endsolid'"},
        {kAscii + "more\n", "mesh.stl:10:1: error: expected 'solid', got 'more'"},
        {kAscii.substr(0, 60), "mesh.stl:5:7: error: the file ends early: expected a number"},
    };
    for (const Case& c : cases) EXPECT_THAT(failure(c.text), HasSubstr(c.message)) << c.text;
}

TEST_F(Stl, AttributesAreNoted) {
    const std::string message = "note: attributes of facets (colours of VisCAM or Materialise) are ignored";
    read(binary(1, facet(kA, kB, kC, kA, 0x8001)));
    EXPECT_THAT(notesText(), HasSubstr(message));
    read(binary(1, facet(kA, kB, kC), "COLOR=\xff\x80\x80\xff"));
    EXPECT_THAT(notesText(), HasSubstr(message));
    read(binary(1, facet(kA, kB, {kNaN, 0, 0})));
    EXPECT_THAT(notesText(), HasSubstr("mesh.stl: note: vertices with NaN or infinite coordinates"));
}

TEST_F(Stl, LoadingStopsOnRequest) {
    std::string facets;
    for (int i = 0; i < 100000; ++i) facets += kQuad;
    const std::string path = write("mesh.stl", binary(200000, facets));
    std::stop_source source;
    const LoadControl control{[&](const std::string& step, double fraction) {
                                  EXPECT_EQ(step, "reading mesh.stl");
                                  if (fraction > 0.1) source.request_stop();
                              },
                              source.get_token()};
    EXPECT_THROW(loadScene(path, notes_, control), Stopped);
}

/// Anything but a scene or an InputError fails the test.
TEST_F(Stl, DamagedFilesAreNeverFatal) {
    std::mt19937 random(1);
    for (const std::string& whole : {binary(2, kQuad), binary(2, kQuad, "solid x\nfacet"), kAscii + kAscii}) {
        std::size_t loaded = 0;
        const auto tryToLoad = [&](const std::string& content) { loaded += failure(content).empty(); };
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
