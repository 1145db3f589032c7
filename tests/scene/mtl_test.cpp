// Every statement of MTL files with good, missing, extra and invalid values.
#include <fmt/format.h>

#include "obj_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

class Mtl : public ObjFiles {
  protected:
    Material with(std::string_view statement) {
        return materialOf(fmt::format("newmtl m\nKd 0.5 0.5 0.5\n{}\n", statement));
    }
    /// The notes about a statement of with(), without their position.
    std::string notesOf(std::string_view statement) {
        with(statement);
        std::string text;
        for (const Diagnostic& note : notes_) {
            EXPECT_EQ(note.position.line, note.message.starts_with("ignored statements") ? 0 : 3)
                << note.message;
            text += note.message + "\n";
        }
        return text;
    }
};

struct ColorCase {
    std::string_view arguments;
    Rgb color;
    std::string_view note;  ///< {}: the keyword
};

TEST_F(Mtl, Colours) {
    const Rgb none(-1.0f);  // the default
    const ColorCase cases[] = {
        {"0.25 0.5 0.75", {0.25f, 0.5f, 0.75f}, ""},
        {"\t0.25\t 0.5 0.75  ", {0.25f, 0.5f, 0.75f}, ""},
        {"0 0 0", {0, 0, 0}, ""},
        {"1 1 1", {1, 1, 1}, ""},
        {"+.25 5e-1 75.0E-2", {0.25f, 0.5f, 0.75f}, ""},
        {"0.25 0.5 0.75 # comment", {0.25f, 0.5f, 0.75f}, ""},
        {"0.25 0.5 0.75#comment", {0.25f, 0.5f, 0.75f}, ""},
        {"0.25", {0.25f, 0.25f, 0.25f}, ""},
        {"0.25 0.5", none, "{} with two numbers instead of one or three; ignored\n"},
        {"", none, "{} without a number; ignored\n"},
        {"# comment", none, "{} without a number; ignored\n"},
        {"0.25 0.5 0.75 1", {0.25f, 0.5f, 0.75f}, "{} with too many numbers; the last ones are ignored\n"},
        {"red", none, "{} with a word instead of a number; ignored\n"},
        {"0.5 x 0.5", {0.5f, 0.5f, 0.5f}, "{} with words behind its numbers; these are ignored\n"},
        {"0.25 0.5 0.75 x", {0.25f, 0.5f, 0.75f}, "{} with words behind its numbers; these are ignored\n"},
        {"0,25 0,5 0,75",
         {0.25f, 0.5f, 0.75f},
         "numbers with a decimal comma; read as a point (3 times, first here)\n"},
        {"0.25,0.5,0.75", none, "{} with a word instead of a number; ignored\n"},
        {"nan 0 0", none, "{} with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"0 0 inf", none, "{} with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"0 -1.#IND 0", none, "{} with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"1e39 0 0", none, "{} with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"-1 0 0.5", {0, 0, 0.5f}, "{} below 0; 0 is used\n"},
        {"255 128 0", {1, 1, 0}, "{} above 1; 1 is used (2 times, first here)\n"},
        {"1e30 0 0", {1, 0, 0}, "{} above 1; 1 is used\n"},
        {"spectral a.rfl 1", none, "{} with a spectral curve, which is not read; ignored\n"},
        {"spectral", none, "{} with a spectral curve, which is not read; ignored\n"},
        {"xyz", none, "{} without a number; ignored\n"},
        {"xyz a b c", none, "{} with a word instead of a number; ignored\n"},
        {"xyz 0.4 0.2", none, "{} with two numbers instead of one or three; ignored\n"},
    };
    for (const ColorCase& c : cases)
        for (const std::string keyword : {"Kd", "Ks"}) {
            SCOPED_TRACE(keyword + " " + std::string(c.arguments));
            std::string note(c.note);
            if (const auto at = note.find("{}"); at != std::string::npos) note.replace(at, 2, keyword);
            EXPECT_EQ(notesOf(fmt::format("{} {}", keyword, c.arguments)), note);
            const Material material = with(fmt::format("{} {}", keyword, c.arguments));
            const Rgb expected = c.color != none ? c.color : keyword == "Kd" ? Rgb(0.5f) : Rgb(0.0f);
            EXPECT_EQ(keyword == "Kd" ? material.kd : material.ks, expected);
        }
}

TEST_F(Mtl, ColoursInXyzAreConverted) {
    // The white point D65 is white.
    const Rgb white = with("Kd xyz 0.9505 1 1.089").kd;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0f, 1e-3f);
    const Rgb red = with("Kd xyz 0.4 0.2 0.02").kd;
    EXPECT_NEAR(red.r, 0.979f, 1e-3f);
    EXPECT_EQ(red.g, 0.0f);
    EXPECT_THAT(notesText(), HasSubstr("m.mtl:3: note: Kd xyz; converted to sRGB\n"));
    EXPECT_THAT(notesText(), HasSubstr("m.mtl:3: warning: Kd below 0; 0 is used\n"));
}

TEST_F(Mtl, AMaterialWithoutKdIsGrey) {
    EXPECT_EQ(materialOf("newmtl m\nKs 0 0 0\n").kd, Rgb(0.8f));
    EXPECT_EQ(notesText(), "m.mtl:1: note: materials without Kd; 0.8 is used\n");
}

struct NumberCase {
    std::string_view statement;
    float value;
    std::string_view note;
};

TEST_F(Mtl, Opacity) {
    const NumberCase cases[] = {
        {"d 0.25", 0.25f, ""},
        {"d 1", 1.0f, ""},
        {"d 0", 0.0f, "materials are invisible by d 0\n"},
        {"d 0,25", 0.25f, "numbers with a decimal comma; read as a point\n"},
        {"d", 1.0f, "d without a number; ignored\n"},
        {"d x", 1.0f, "d with a word instead of a number; ignored\n"},
        {"d 0.25 0.5", 0.25f, "d with too many numbers; the last ones are ignored\n"},
        {"d nan", 1.0f, "d with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"d inf", 1.0f, "d with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"d -0.5", 0.0f, "d below 0; 0 is used\nmaterials are invisible by d 0\n"},
        {"d 2", 1.0f, "d above 1; 1 is used\n"},
        {"d 100", 1.0f, "d above 1; 1 is used\n"},
        {"d -halo 0.25", 0.25f, "d -halo; read as d\n"},
        {"d -halo", 1.0f, "d -halo; read as d\nd without a number; ignored\n"},
        {"Tr 0.25", 0.75f, ""},
        {"Tr 0", 1.0f, ""},
        {"Tr 1.000000", 0.0f, "materials are invisible by Tr 1\n"},
        {"Tr", 1.0f, "Tr without a number; ignored\n"},
        {"Tr x", 1.0f, "Tr with a word instead of a number; ignored\n"},
        {"Tr 0,25", 0.75f, "numbers with a decimal comma; read as a point\n"},
        {"Tr nan", 1.0f, "Tr with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"Tr -1", 1.0f, "Tr below 0; 0 is used\n"},
        {"Tr 2", 0.0f, "Tr above 1; 1 is used\nmaterials are invisible by Tr 1\n"},
    };
    for (const NumberCase& c : cases) {
        EXPECT_EQ(with(c.statement).opacity, c.value) << c.statement;
        EXPECT_EQ(notesOf(c.statement), c.note) << c.statement;
    }
    for (const std::string_view both : {"d 0.25\nTr 0.5", "Tr 0.5\nd 0.25"}) {
        EXPECT_EQ(with(both).opacity, 0.25f);
        EXPECT_EQ(notesText(), "m.mtl:4: note: d and Tr that contradict each other; d is used\n");
    }
    for (const std::string_view both : {"d 0.7\nTr 0.3", "Tr 0.9\nd 0.1", "d 0.333\nTr 0.667"}) {
        with(both);
        EXPECT_EQ(notesText(), "") << both;
    }
}

TEST_F(Mtl, Shininess) {
    const NumberCase cases[] = {
        {"Ns 30", 30.0f, ""},
        {"Ns 0", 0.0f, ""},
        {"Ns 96.078431", 96.078431f, ""},
        {"Ns 1e30", 1e30f, ""},
        {"Ns 96,5", 96.5f, "numbers with a decimal comma; read as a point\n"},
        {"Ns", 1.0f, "Ns without a number; ignored\n"},
        {"Ns x", 1.0f, "Ns with a word instead of a number; ignored\n"},
        {"Ns 1 2", 1.0f, "Ns with too many numbers; the last ones are ignored\n"},
        {"Ns nan", 1.0f, "Ns with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"Ns inf", 1.0f, "Ns with NaN, infinity or a number beyond the range of floats; ignored\n"},
        {"Ns -5", 0.0f, "Ns below 0; 0 is used\n"},
    };
    for (const NumberCase& c : cases) {
        EXPECT_EQ(with(c.statement).shininess, c.value) << c.statement;
        EXPECT_EQ(notesOf(c.statement), c.note) << c.statement;
    }
}

TEST_F(Mtl, Illumination) {
    for (int illum = 0; illum <= 10; ++illum) EXPECT_EQ(with(fmt::format("illum {}", illum)).illum, illum);
    EXPECT_EQ(with("illum 2.0").illum, 2);
    EXPECT_EQ(with("").illum, -1);
    for (const std::string_view value : {"-1", "11", "2.5", "1e9"})
        EXPECT_EQ(notesOf(fmt::format("illum {}", value)), "illum is not an integer from 0 to 10; ignored\n");
    for (const std::string_view value : {"-1", "2.5", "x", "", "nan"})
        EXPECT_EQ(with(fmt::format("illum {}", value)).illum, -1);
    EXPECT_EQ(notesOf("illum x"), "illum with a word instead of a number; ignored\n");
    EXPECT_EQ(notesOf("illum"), "illum without a number; ignored\n");
}

TEST_F(Mtl, FloatsAreReadExactly) {
    const std::pair<std::string_view, float> numbers[] = {{"0.1", 0.1f},
                                                          {"0.2", 0.2f},
                                                          {"0.3", 0.3f},
                                                          {"0.7", 0.7f},
                                                          {"0.065", 0.065f},
                                                          {"0.091", 0.091f},
                                                          {"0.333333343", 0.333333343f},
                                                          {"0.999999940", 0.999999940f},
                                                          {"1e-10", 1e-10f},
                                                          {"1e-38", 1e-38f},
                                                          {"0.0784313725", 0.0784313725f}};
    for (const auto& [digits, value] : numbers)
        EXPECT_EQ(with(fmt::format("Kd {0} {0} {0}", digits)).kd, Rgb(value)) << digits;
}

TEST_F(Mtl, StatementsWithoutEffectAreListedOnce) {
    for (const std::string_view keyword :
         {"Ka",     "Ke",       "Kt",       "Tf",       "Ni",      "sharpness", "bump",   "disp",
          "decal",  "refl",     "norm",     "map_Ka",   "map_Ks",  "map_Ke",    "map_Ns", "map_d",
          "map_Tr", "map_bump", "map_Bump", "map_disp", "map_aat", "Pr",        "Pm",     "Ps",
          "Pc",     "Pcr",      "aniso",    "anisor",   "map_Pr",  "map_Pm",    "map_Ps", "whatever"})
        for (const std::string_view arguments : {"0.5 0.5 0.5", "", "nan", "x.png", "-bm 2 x.png"}) {
            const Material material = with(fmt::format("{0} {1}\n{0} {1}", keyword, arguments));
            EXPECT_EQ(notesText(), fmt::format("m.mtl: note: ignored statements: {}\n", keyword));
            EXPECT_EQ(material.kd, Rgb(0.5f));
            EXPECT_FALSE(material.kdTexture);
        }
}

TEST_F(Mtl, KeywordsMayDifferInCase) {
    EXPECT_EQ(with("KS 0.25\nNS 7").ks, Rgb(0.25f));
    EXPECT_EQ(
        notesText(),
        "m.mtl:3: note: keywords in another case than in the specification; read (2 times, first here)\n");
    EXPECT_EQ(materialOf("NewMtl m\nkd 0 1 0\n").kd, Rgb(0, 1, 0));
}

TEST_F(Mtl, LinesAreReadAsInObjFiles) {
    EXPECT_EQ(materialOf("newmtl m\rKd 0 1 0\r").kd, Rgb(0, 1, 0));
    EXPECT_EQ(materialOf("\xef\xbb\xbfnewmtl m\r\n\tKd 0 \\\r\n1 0\r\n").kd, Rgb(0, 1, 0));
    EXPECT_EQ(materialOf("Kd 1 0 0\nnewmtl m\nKd 0 1 0\n").kd, Rgb(0, 1, 0));
    EXPECT_EQ(notesText(), "m.mtl:1: warning: statements before the first newmtl; ignored\n");
}

TEST_F(Mtl, FilesThatAreNoMtlFilesAreWarnings) {
    materialOf("root:$y$secret:19000\ndaemon word\n");
    EXPECT_THAT(notesText(), HasSubstr("m.mtl: warning: is not an MTL file: it has no newmtl statement\n"));
    EXPECT_EQ(notesText().find("daemon"), std::string::npos);
    EXPECT_EQ(materialOf("\x89PNG\r\n\x1a\n").kd, Rgb(0.8f));
    EXPECT_THAT(notesText(), HasSubstr("not a file in MTL format: it is a PNG image"));
    EXPECT_THAT(notesText(), HasSubstr("default materials are used"));
}

}  // namespace
}  // namespace rayscope::test
