// `rayscope compare` with verdicts, against differences that are known and against idiff of OpenImageIO.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "image/srgb.h"
#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

Rgb grey(int code) { return Rgb(image::decodeByte(static_cast<std::uint8_t>(code))); }

/// An image of one code with `count` pixels of another one.
void writeGrey(const TemporaryFolder& folder, const std::string& name, int code, int count = 0,
               int other = 0) {
    RgbImage image(20, 10, grey(code));
    for (int i = 0; i < count; ++i) image.pixels[static_cast<std::size_t>(7 * i)] = grey(other);
    std::filesystem::create_directories((folder / name).parent_path());
    writeImage(folder.file(name), image);
}

TEST(CompareVerdict, ToleranceAndShareDecide) {
    const TemporaryFolder folder;
    writeGrey(folder, "b.png", 100);
    writeGrey(folder, "a.png", 100, 2, 105);  // 1 % of the pixels
    ProgramResult result = run(folder, "rayscope compare a.png b.png --tolerance 4/255 --share 1%");
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out,
              "a.png: passes: 1 % of the pixels differ by more than 0.01569, the largest by 0.01961 at pixel "
              "0,0\n");
    EXPECT_EQ(run(folder, "rayscope compare a.png b.png --tolerance 5/255").exitCode, 0);
    result = run(folder, "rayscope compare a.png b.png --tolerance 4/255 --share 0.9%");
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_EQ(result.out, "a.png: fails: 1 % of the pixels differ by more than 0.01569; at most 0.9 % may\n");
    result = run(folder, "rayscope compare a.png b.png --tolerance 4/255 --share 1% --hard-limit 4.5/255");
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_THAT(result.out, HasSubstr("2 pixels differ by more than the hard limit of 0.01765"));
    result = run(folder, "rayscope compare b.png b.png --tolerance 0 --score");
    EXPECT_EQ(result.out, "b.png: passes: equal; score 100.0\n");
}

TEST(CompareVerdict, SeveralLimitsHoldAtOnce) {
    const TemporaryFolder folder;
    writeGrey(folder, "b.png", 100);
    writeGrey(folder, "a.png", 101);
    EXPECT_EQ(run(folder, "rayscope compare a.png b.png --tolerance 1/255 --limit rmse=0.1 --limit flip=0.5")
                  .exitCode,
              0);
    const ProgramResult result =
        run(folder, "rayscope compare a.png b.png --limit rmse=1e-6 --limit max=1e-7 --tolerance 1/255");
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_THAT(result.out, HasSubstr("rmse is 0.0"));
    EXPECT_THAT(result.out, HasSubstr("max is 0.0"));
    EXPECT_THAT(result.out, Not(HasSubstr("of the pixels")));
    EXPECT_EQ(
        run(folder, "rayscope compare a.png b.png --tolerance 1/255 --metric max --fail-above 1e-7").exitCode,
        4);
}

TEST(CompareVerdict, WritesTheDifferencesOfTheRule) {
    const TemporaryFolder folder;
    writeGrey(folder, "b.png", 100);
    writeGrey(folder, "a.png", 100, 1, 151);
    EXPECT_EQ(run(folder, "rayscope compare a.png b.png --tolerance 0.5 -o d.pfm").exitCode, 0);
    const RgbImage differences = readImage(folder.file("d.pfm"));
    EXPECT_EQ(differences.at(0, 0), Rgb(0.2f));
    EXPECT_EQ(differences.at(1, 0), Rgb(0.0f));
}

TEST(CompareVerdict, FoldersAreComparedByName) {
    const TemporaryFolder folder;
    for (const char* name : {"cornell.png", "sub/teapot.png", "missing.png", "damaged.png", "size.png"})
        writeGrey(folder, std::string("ref/") + name, 100);
    writeGrey(folder, "hand-in/cornell.ppm", 101);  // another format
    writeGrey(folder, "hand-in/sub/teapot.png", 140);
    writeGrey(folder, "hand-in/extra.png", 0);
    folder.write("hand-in/damaged.png", "no image");
    folder.write("hand-in/notes.txt", "not compared");
    writeImage(folder.file("hand-in/size.png"), RgbImage(3, 4));
    const ProgramResult result =
        run(folder, "rayscope compare hand-in ref --tolerance 4/255 --score --html r.html --junit r.xml");
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_THAT(result.out, HasSubstr("cornell.png: passes: 0 % of the pixels differ by more than 0.01569"));
    EXPECT_THAT(result.out, HasSubstr("sub/teapot.png: fails: 100 % of the pixels differ"));
    EXPECT_THAT(result.out, HasSubstr("missing.png: fails: there is no image of this name; score 0.0"));
    EXPECT_THAT(result.out, HasSubstr("damaged.png: fails: hand-in/damaged.png: error: not an image"));
    EXPECT_THAT(result.out, HasSubstr("size.png: fails: the image has 3 x 4 pixels, the reference 20 x 10"));
    EXPECT_THAT(result.out, HasSubstr("1 of 5 pass\n"));
    EXPECT_EQ(result.err, "extra.png: note: there is no reference image of this name\n");

    const std::string page = test::readText(folder / "r.html");
    EXPECT_THAT(page, HasSubstr("sub/teapot.png"));
    EXPECT_THAT(page, HasSubstr("<input type='range'"));
    EXPECT_THAT(page, Not(HasSubstr("src='http")));
    const std::string xml = test::readText(folder / "r.xml");
    EXPECT_THAT(xml, HasSubstr("tests=\"5\" failures=\"4\""));
    EXPECT_THAT(xml,
                HasSubstr("<testcase classname=\"compare\" name=\"missing.png\"><failure message=\"there "
                          "is no image of this name\"/></testcase>"));
}

TEST(CompareVerdict, PrintsJson) {
    const TemporaryFolder folder;
    writeGrey(folder, "ref/a.png", 100);
    writeGrey(folder, "ref/b.png", 100);
    writeGrey(folder, "in/a.png", 100, 3, 151);
    const ProgramResult result = run(folder, "rayscope compare in ref --json");
    EXPECT_EQ(result.exitCode, 4);
    const nlohmann::json json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["passed"], 0);
    EXPECT_EQ(json["failed"], 2);
    const nlohmann::json& verdict = json["pairs"][0]["verdict"];
    EXPECT_EQ(verdict["differing"], 3);
    EXPECT_EQ(verdict["share"], 0.015);
    EXPECT_EQ(verdict["largest"], 0.2);
    EXPECT_EQ(json["pairs"][1]["verdict"], nullptr);
    EXPECT_EQ(json["pairs"][1]["reasons"][0], "there is no image of this name");
}

TEST(CompareVerdict, NamesAreEscapedInReports) {
    const TemporaryFolder folder;
    writeGrey(folder, "ref/<b>&'\".png", 100);
    EXPECT_EQ(run(folder, "rayscope compare ref ref --html r.html --junit r.xml").exitCode, 0);
    EXPECT_THAT(test::readText(folder / "r.html"), HasSubstr("&lt;b&gt;&amp;&#39;&quot;.png"));
    EXPECT_THAT(test::readText(folder / "r.html"), Not(HasSubstr("<b>&'")));
    EXPECT_THAT(test::readText(folder / "r.xml"), HasSubstr("name=\"&lt;b&gt;&amp;&#39;&quot;.png\""));
}

TEST(CompareVerdict, WrongValuesAreNamed) {
    const TemporaryFolder folder;
    writeGrey(folder, "a.png", 100);
    std::filesystem::create_directories(folder / "empty");
    for (const char* options :
         {"--tolerance -1", "--tolerance nan", "--tolerance 1/0", "--tolerance x", "--tolerance 4/",
          "--share 2", "--share 101%", "--neighbourhood 2", "--neighbourhood 17", "--limit rmse",
          "--limit rmse=x", "--hard-limit inf", "--values srgb", "--tolerance 1 --map m.csv"}) {
        const ProgramResult result = run(folder, std::string("rayscope compare a.png a.png ") + options);
        EXPECT_EQ(result.exitCode, 1) << options << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: --")) << options;
    }
    EXPECT_THAT(run(folder, "rayscope compare a.png a.png --limit rms=1").err,
                HasSubstr("did you mean 'rmse'"));
    EXPECT_EQ(run(folder, "rayscope compare a.png empty").exitCode, 2);
    const ProgramResult empty = run(folder, "rayscope compare empty empty");
    EXPECT_EQ(empty.exitCode, 2);
    EXPECT_EQ(empty.err, "empty: error: has no image files; expected .png .exr .pfm .hdr .jpg .ppm …\n");
    EXPECT_EQ(run(folder, "rayscope compare empty empty -o d.png").exitCode, 1);
}

/// Limits lie between two codes, because idiff computes in float, where the difference of codes 4/255 apart
/// may be larger than 4/255. The hard limit is not below the tolerance, where idiff ignores it.
void expectVerdictsOfIdiff(int pairs) {
    const TemporaryFolder folder;
    std::mt19937 random(11);
    int passes = 0;
    std::ofstream script(folder.path() / "idiff.sh");
    std::vector<std::string> ours;
    for (int i = 0; i < pairs; ++i) {
        RgbImage a(16, 12), b = a;
        const int spread = static_cast<int>(random() % 12u);
        for (std::size_t k = 0; k < a.pixels.size(); ++k) {
            glm::ivec3 code, other;
            for (int c = 0; c < 3; ++c) {
                code[c] = static_cast<int>(random() % 256u);
                const bool changes = random() % 8u == 0;
                const int change =
                    changes ? static_cast<int>(random() % static_cast<unsigned>(2 * spread + 1)) - spread : 0;
                other[c] = std::clamp(code[c] + change, 0, 255);
            }
            for (int c = 0; c < 3; ++c) {
                a.pixels[k][c] = grey(code[c]).r;
                b.pixels[k][c] = grey(other[c]).r;
            }
        }
        const std::string number = std::to_string(i);
        writeImage(folder.file("a" + number + ".png"), a);
        writeImage(folder.file("b" + number + ".png"), b);
        const auto below = [&](unsigned count) { return static_cast<double>(random() % count); };
        const double code = below(8) + 0.5, tolerance = code / 255.0, share = below(20) + 0.25,
                     hard = (code + below(8)) / 255.0;
        script << "idiff -q -fail " << tolerance << " -failpercent " << share << " -hardfail " << hard << " a"
               << number << ".png b" << number << ".png >/dev/null 2>&1; echo $? >>verdicts\n";
        const ProgramResult result =
            run(folder, "rayscope compare a" + number + ".png b" + number + ".png --tolerance " +
                            std::to_string(tolerance) + " --share " + std::to_string(share) +
                            "% --hard-limit " + std::to_string(hard));
        ASSERT_TRUE(result.exitCode == 0 || result.exitCode == 4) << result.err;
        ours.push_back(result.exitCode == 0 ? "0" : "2");
        passes += result.exitCode == 0;
    }
    script.close();
    run(folder, "sh idiff.sh");
    std::ifstream verdicts(folder.path() / "verdicts");
    for (int i = 0; i < pairs; ++i) {
        std::string theirs;
        ASSERT_TRUE(std::getline(verdicts, theirs));
        if (theirs == "1") theirs = "0";  // a warning is no failure
        EXPECT_EQ(ours[static_cast<std::size_t>(i)], theirs) << "pair " << i;
    }
    EXPECT_GT(passes, pairs / 10);
    EXPECT_LT(passes, pairs * 9 / 10);
}

// $RAYSCOPE_IDIFF_PAIRS pairs; idiff takes some .2 s for each.
TEST(CompareVerdict, AgreesWithIdiffOnRandomPairs) {
    if (std::system("command -v idiff >/dev/null") != 0) GTEST_SKIP() << "idiff is not installed";
    const char* const requested = std::getenv("RAYSCOPE_IDIFF_PAIRS");
    expectVerdictsOfIdiff(requested ? std::atoi(requested) : 40);
}

}  // namespace
}  // namespace rayscope
