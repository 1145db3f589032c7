// Numbers of v, vt and vn.
#include <fmt/format.h>

#include <charconv>
#include <clocale>
#include <cmath>
#include <locale>
#include <random>

#include "obj_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

const std::string kFace = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";

class ObjNumbers : public ObjFiles {
  protected:
    /// The first vertex of a mesh, from its statement.
    glm::vec3 vertexOf(std::string_view statement) {
        return meshOf(read(fmt::format("{}\n{}", statement, kFace))).positions.at(0);
    }
};

TEST_F(ObjNumbers, AllSpellingsOfDecimalNumbersAreRead) {
    const std::pair<std::string_view, float> words[] = {
        {"1", 1},
        {"+1", 1},
        {"-1", -1},
        {"1.", 1},
        {".5", 0.5f},
        {"-.5", -0.5f},
        {"+.5", 0.5f},
        {"1e1", 10},
        {"1E1", 10},
        {"1e+1", 10},
        {"1e-1", 0.1f},
        {"1.e1", 10},
        {".5e1", 5},
        {"00012", 12},
        {"-0", -0.0f},
        {"1e-45", 1e-45f},
        {"3e38", 3e38f},
        {"1e-99", 0.0f},
        {"-1e-999", -0.0f},
        {"0.1", 0.1f},
        {"16777217", 16777216},
        {"0.333333333333333333333333333333333333", 1.0f / 3.0f},
    };
    for (const auto& [word, value] : words) {
        const glm::vec3 vertex = vertexOf(fmt::format("v {0} {0} {0}", word));
        EXPECT_EQ(vertex, glm::vec3(value)) << word;
        EXPECT_EQ(std::signbit(vertex.x), std::signbit(value)) << word;
    }
}

TEST_F(ObjNumbers, EveryFloatSurvivesTheText) {
    std::mt19937 random(7);
    std::string text;
    std::vector<float> values;
    while (values.size() < 3000) {
        const auto bits = static_cast<std::uint32_t>(random());
        const float value = std::bit_cast<float>(bits);
        if (std::isfinite(value)) values.push_back(value);
    }
    for (std::size_t i = 0; i < values.size(); i += 3)
        text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", values[i], values[i + 1], values[i + 2]);
    text += "f";
    for (std::size_t i = 1; i <= 1000; ++i) text += fmt::format(" {}", i);
    const SceneDescription scene = read(text + "\n");
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(meshOf(scene).positions[i / 3][static_cast<int>(i % 3)], values[i]);
}

TEST_F(ObjNumbers, NonFiniteVerticesAreKeptAndNoted) {
    for (const std::string_view word :
         {"nan",     "NaN",     "NAN",      "-nan",   "nan(ind)",  "-nan(ind)", "inf",
          "-inf",    "INF",     "infinity", "1e39",   "-1e39",     "1e400",     "1.#IND",
          "-1.#IND", "1.#QNAN", "-1.#QNAN", "1.#INF", "-1.#INF00", "1.#IND00"}) {
        EXPECT_FALSE(std::isfinite(vertexOf(fmt::format("v {} 0 0", word)).x)) << word;
        EXPECT_EQ(notesText(),
                  "mesh.obj:1: note: vertices with NaN or infinite coordinates; rays never hit their "
                  "triangles\n")
            << word;
    }
    const SceneDescription scene =
        read("v 0 0 0\nv nan 0 0\nv 0 -inf 0\nv 1 1 1e60\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 4 5\nf 1 5 6\n");
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:2: note: vertices with NaN"));
    EXPECT_THAT(notesText(), HasSubstr("(3 times, first here)"));
    EXPECT_EQ(boundsOf(scene).upper, glm::vec3(1, 1, 0)) << "bounds of the finite vertices";
    EXPECT_EQ(vertexOf("v 3e38 3e38 3e38"), glm::vec3(3e38f));
    EXPECT_EQ(notesText(), "") << "finite, although the sum of the coordinates is not";
}

TEST_F(ObjNumbers, WordsThatAreNoNumbersAreErrorsThatQuoteThem) {
    for (const std::string_view word : {"zero", "1e", "1e+", "--1", "+-1", "-", "+", ".", "1.5.5", "1.5-2.5",
                                        "1.5f", "0x10", "1d3", "1/2", "1_000", "(1", "1'000"})
        for (const std::string_view keyword : {"v", "vn"})
            EXPECT_EQ(
                failure(fmt::format("{} 0 {} 0\n{}", keyword, word, kFace)),
                fmt::format("mesh.obj:1:{}: error: expected a number, got '{}'", keyword.size() + 4, word));
    for (const std::string_view word : {"0,5", "1,5e3", "1,2,3", "-0,5"})
        EXPECT_EQ(
            failure(fmt::format("v {} 0 0\n{}", word, kFace)),
            fmt::format("mesh.obj:1:3: error: expected a number, got '{}'; the decimal separator is a point",
                        word));
    EXPECT_EQ(failure("vt abc\n" + kFace), "mesh.obj:1:4: error: expected a number, got 'abc'");
}

TEST_F(ObjNumbers, MissingNumbersAreErrors) {
    EXPECT_EQ(failure("v\n" + kFace), "mesh.obj:1:2: error: expected 3 numbers, got 0");
    EXPECT_EQ(failure("v 1\n" + kFace), "mesh.obj:1:2: error: expected 3 numbers, got 1");
    EXPECT_EQ(failure("v 0 0 # end\n" + kFace), "mesh.obj:1:2: error: expected 3 numbers, got 2");
    EXPECT_EQ(failure("vn 0 0\n" + kFace), "mesh.obj:1:3: error: expected 3 numbers, got 2");
    EXPECT_EQ(failure("vt\n" + kFace), "mesh.obj:1:3: error: expected 1 number, got 0");
}

TEST_F(ObjNumbers, ExtraNumbersAreWeightsOrColours) {
    const std::tuple<std::string_view, bool, std::string_view> statements[] = {
        {"v 5 6 7", false, ""},
        {"v 5 6 7 1", false, ""},
        {"v 5 6 7 1.0 # w", false, ""},
        {"v 5 6 7 0.5", false,
         "mesh.obj:1: note: vertices with a weight other than 1; the weight is ignored\n"},
        {"v 5 6 7 1 2", false, "mesh.obj:1: warning: vertices with 5 numbers; the last two are ignored\n"},
        {"v 5 6 7 1 0 0", true, ""},
        {"v 5 6 7 1 0 0 1", true,
         "mesh.obj:1: note: vertices with numbers behind the colour; these are ignored\n"},
        {"v 5 6 7 1 0 0 1 2 3 4", true,
         "mesh.obj:1: note: vertices with numbers behind the colour; these are ignored\n"},
        {"v 5 6 7 red", false, "mesh.obj:1: warning: words behind the numbers of a statement; ignored\n"},
        {"v 5 6 7 // c", false, "mesh.obj:1: warning: words behind the numbers of a statement; ignored\n"},
    };
    for (const auto& [statement, hasColor, note] : statements) {
        SCOPED_TRACE(statement);
        const auto mesh = readWithColors(fmt::format("{}\n{}", statement, kFace));
        EXPECT_EQ(mesh->positions[0], glm::vec3(5, 6, 7));
        ASSERT_EQ(mesh->colors.size(), hasColor ? 3u : 0u);
        if (hasColor) {
            EXPECT_EQ(mesh->colors[0], Rgb(1, 0, 0));
            EXPECT_THAT(notesText(), HasSubstr(note));
        } else {
            EXPECT_EQ(notesText(), note);
        }
    }
}

TEST_F(ObjNumbers, ColoursAreDecodedFromSrgb) {
    const auto mesh = readWithColors("v 0 0 0 0 0.5 1\nv 1 0 0 1 1 1\nv 0 1 0 0.02 0.2 0.8\nf 1 2 3\n");
    const std::vector<Rgb>& colors = mesh->colors;
    EXPECT_EQ(colors[0].r, 0.0f);
    EXPECT_NEAR(colors[0].g, 0.21404114f, 1e-6f);
    EXPECT_EQ(colors[0].b, 1.0f);
    EXPECT_NEAR(colors[2].r, 0.02f / 12.92f, 1e-6f);
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjNumbers, ColoursOutOfRange) {
    const auto bytes = readWithColors("v 0 0 0 255 0 51\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
    EXPECT_NEAR(bytes->colors[0].b, 0.0331048f, 1e-6f) << "0.2";
    EXPECT_EQ(notesText(), "mesh.obj: warning: vertex colours above 2; all are read as 0 to 255\n");
    const auto odd = readWithColors("v 0 0 0 -1 0 0.5\nv 1 0 0\nv 0 1 0 nan 0 0\nf 1 2 3\n");
    EXPECT_EQ(odd->colors[0].r, 0.0f);
    EXPECT_EQ(odd->colors[1], Rgb(1.0f));
    EXPECT_EQ(odd->colors[2], Rgb(1.0f));
    EXPECT_EQ(notesText(),
              "mesh.obj: note: vertices without a colour in a file with colours; white is used (2 times)\n"
              "mesh.obj: warning: colours of vertices out of range; clamped\n");
}

TEST_F(ObjNumbers, ColoursThatAreNotShownAreNoted) {
    EXPECT_TRUE(meshOf(read("v 0 0 0 1 0 0\n" + kFace)).colors.empty());
    EXPECT_EQ(notesText(),
              "mesh.obj: note: vertex colours are not shown; vertex_colors = true in [[mesh]] shows them\n");
}

TEST_F(ObjNumbers, TextureCoordinatesHaveOneToThreeNumbers) {
    const SceneDescription scene = read(kTriangle + "vt 0.5\nvt 0 1 0\nvt nan 0.5\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(meshOf(scene).texCoords[0], glm::vec2(0.5f, 0));
    EXPECT_EQ(meshOf(scene).texCoords[1], glm::vec2(0, 1));
    EXPECT_EQ(meshOf(scene).texCoords[2], glm::vec2(0, 0.5f));
    EXPECT_EQ(notesText(), "mesh.obj:6: warning: texture coordinates that are not finite; 0 is used\n");
}

TEST_F(ObjNumbers, MissingNormalsAreRightAtAllSizes) {
    for (const std::string_view size : {"1e-40", "1e-25", "1e-10", "1", "1e10", "1e20", "1e30", "1e38"}) {
        const SceneDescription scene = read(fmt::format(
            "vn 0 0 1\nv 0 0 0\nv {0} 0 0\nv {0} {0} 0\nv 0 {0} 0\nf 1//1 2//1 3//1\nf 1 3 4\n", size));
        for (const glm::vec3& normal : meshOf(scene).normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << size;
    }
}

TEST_F(ObjNumbers, DoNotDependOnTheLocale) {
    // A locale of C++ needs no installed one; the C locale is changed too, where one is installed.
    struct CommaPoint : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
    };
    const char* before = std::setlocale(LC_ALL, nullptr);
    const std::string saved = before ? before : "C";
    const std::locale savedGlobal = std::locale::global(std::locale(std::locale(), new CommaPoint));
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);
    const glm::vec3 vertex = vertexOf("v 0.5 0 0");
    const Material material = materialOf("newmtl m\nKd 0.25 0.5 0.75\nNs 1.5\n");
    std::locale::global(savedGlobal);
    std::setlocale(LC_ALL, saved.c_str());
    EXPECT_EQ(vertex.x, 0.5f);
    EXPECT_EQ(material.kd, Rgb(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(material.shininess, 1.5f);
}

}  // namespace
}  // namespace rayscope::test
