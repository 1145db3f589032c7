#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

/// a and b differ by 0.5 in one of 40 × 20 pixels.
void writePair(const TemporaryFolder& folder) {
    RgbImage image(40, 20, Rgb(0.25f));
    writeImage(folder.file("b.exr"), image);
    image.at(35, 10) = Rgb(0.75f);
    for (const char* name : {"a.exr", "a.pfm", "a.hdr", "a.png"}) writeImage(folder.file(name), image);
}

TEST(CompareCommand, ReadsEveryFormatAndPrintsEveryMetric) {
    const TemporaryFolder folder;
    writePair(folder);
    for (const char* name : {"a.exr", "a.pfm", "a.hdr"}) {
        const ProgramResult result = run(folder, std::string("rayscope compare ") + name + " b.exr --json");
        ASSERT_EQ(result.exitCode, 0) << result.err;
        const nlohmann::json errors = nlohmann::json::parse(result.out);
        EXPECT_NEAR(errors["rmse"], 0.5 / std::sqrt(800.0), 1e-3) << name;
        EXPECT_EQ(errors["max_at"], nlohmann::json({35, 10}));
    }
    EXPECT_EQ(run(folder, "rayscope compare a.png b.exr --metric flip --fail-above 0.1").exitCode, 0);
    const ProgramResult text = run(folder, "rayscope compare a.exr b.exr");
    for (const char* name : {"rmse", "relmse", "smape", "max", "ssim", "flip", "mean difference"})
        EXPECT_THAT(text.out, HasSubstr(name));
}

TEST(CompareCommand, PrintsWhatTheReadersIgnored) {
    const TemporaryFolder folder;
    folder.write("a.pgm", "P5\n1 1\n255\na...");
    folder.write("b.pgm", "P5\n1 1\n255\na");
    const ProgramResult result = run(folder, "rayscope compare a.pgm b.pgm --metric max --fail-above 0");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "a.pgm: warning: 3 bytes behind the pixels are ignored\n");
}

TEST(CompareCommand, FailsAboveTheLimitOnly) {
    const TemporaryFolder folder;
    writePair(folder);
    EXPECT_EQ(run(folder, "rayscope compare a.exr b.exr --metric max --fail-above 0.5").exitCode, 0);
    const ProgramResult above = run(folder, "rayscope compare a.exr b.exr --metric max --fail-above 0.49");
    EXPECT_EQ(above.exitCode, 4);
    EXPECT_THAT(above.err, HasSubstr("max is 0.5, above 0.49"));
    EXPECT_EQ(run(folder, "rayscope compare b.exr b.exr --fail-above 0").exitCode, 0);
    EXPECT_EQ(run(folder, "rayscope compare b.exr b.exr --metric ssim --fail-above 1e-9").exitCode, 0);
}

TEST(CompareCommand, WritesErrorsInFalseColourAndAsValues) {
    const TemporaryFolder folder;
    writePair(folder);
    const ProgramResult result = run(folder, "rayscope compare a.exr b.exr -o d.png --metric max");
    EXPECT_THAT(result.out, HasSubstr("white for 0.5"));
    const RgbImage colors = readImage(folder.file("d.png"));
    EXPECT_EQ(colors.at(35, 10), Rgb(1.0f));
    EXPECT_EQ(colors.at(0, 0), Rgb(0.0f));
    run(folder, "rayscope compare a.exr b.exr -o d.pfm --metric max");
    EXPECT_EQ(readImage(folder.file("d.pfm")).at(35, 10), Rgb(0.5f));
}

TEST(CompareCommand, WritesAMapOfTiles) {
    const TemporaryFolder folder;
    writePair(folder);
    run(folder, "rayscope compare a.exr b.exr --metric max --map m.csv --tile 20");
    EXPECT_EQ(test::readText(folder / "m.csv"), "x0,x1,y0,y1,max\n0,20,0,20,0\n20,40,0,20,0.5\n");
    run(folder, "rayscope compare a.exr b.exr --metric max --map m.pfm --tile 16");
    const RgbImage tiles = readImage(folder.file("m.pfm"));
    EXPECT_EQ(tiles.at(33, 1), Rgb(0.5f));
    EXPECT_EQ(tiles.at(31, 1), Rgb(0.0f));
    EXPECT_EQ(tiles.at(33, 17), Rgb(0.0f));
}

TEST(CompareCommand, ReportsNonFinitePixels) {
    const TemporaryFolder folder;
    writePair(folder);
    RgbImage broken = readImage(folder.file("b.exr"));
    broken.at(1, 2) = Rgb(NAN);
    writeImage(folder.file("n.exr"), broken);
    const ProgramResult result = run(folder, "rayscope compare n.exr b.exr --json");
    EXPECT_EQ(result.exitCode, 5);
    EXPECT_THAT(result.err, HasSubstr("n.exr: error: 1 of 800 pixels"));
    EXPECT_EQ(nlohmann::json::parse(result.out)["non_finite_a"], 1);
    EXPECT_EQ(run(folder, "rayscope compare n.exr b.exr --fail-above 1").exitCode, 5);
    writeImage(folder.file("all.exr"), RgbImage(40, 20, Rgb(NAN)));
    const ProgramResult nothing = run(folder, "rayscope compare all.exr b.exr --json --fail-above 1");
    EXPECT_EQ(nothing.exitCode, 4);
    EXPECT_TRUE(nlohmann::json::parse(nothing.out)["rmse"].is_null());
}

TEST(CompareCommand, RejectsImagesThatCannotBeCompared) {
    const TemporaryFolder folder;
    writePair(folder);
    writeImage(folder.file("small.exr"), RgbImage(4, 4, Rgb(0.0f)));
    folder.write("text.exr", "no image");
    const ProgramResult size = run(folder, "rayscope compare a.exr small.exr");
    EXPECT_EQ(size.exitCode, 2);
    EXPECT_THAT(size.err, HasSubstr("40 x 20 and 4 x 4"));
    EXPECT_EQ(run(folder, "rayscope compare a.exr text.exr").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope compare a.exr missing.exr").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope compare a.exr b.exr -o nowhere/d.png").exitCode, 2);
    const ProgramResult metric = run(folder, "rayscope compare a.exr b.exr --metric flop");
    EXPECT_EQ(metric.exitCode, 2);
    EXPECT_THAT(metric.err, HasSubstr("did you mean 'flip'"));
    EXPECT_EQ(run(folder, "rayscope compare a.exr").exitCode, 1);
}

}  // namespace
}  // namespace rayscope
