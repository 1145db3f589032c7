#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(Render, WritesEveryFormatFromOneRun) {
    const TemporaryFolder folder;
    const ProgramResult result = run(folder,
                                     "rayscope render builtin:cornell --size 40x30 --spp 2 --set exposure=1 "
                                     "-o a.png -o a.exr -o a.pfm -o a.hdr "
                                     "-o a.ppm -o a.pgm");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out, "");
    const RgbImage exr = readImage(folder / "a.exr"), pfm = readImage(folder / "a.pfm");
    EXPECT_EQ(exr.width, 40);
    EXPECT_EQ(exr.height, 30);
    EXPECT_EQ(exr.pixels, pfm.pixels);
    EXPECT_EQ(readImage(folder / "a.png").width, 40);
    EXPECT_EQ(readImage(folder / "a.ppm").pixels, readImage(folder / "a.png").pixels);
    EXPECT_EQ(readImage(folder / "a.pgm").width, 40);
    EXPECT_EQ(readImage(folder / "a.hdr").height, 30);
}

TEST(Render, IsReproducibleForAnyThreadsAndBvh) {
    const TemporaryFolder folder;
    for (const char* threads : {"1", "2", "5"})
        ASSERT_EQ(run(folder, std::string("rayscope render builtin:cornell-area --size 30x30 --spp 3 -t ") +
                                  threads + " -o t" + threads + ".pfm")
                      .exitCode,
                  0);
    EXPECT_EQ(test::readText(folder / "t1.pfm"), test::readText(folder / "t2.pfm"));
    EXPECT_EQ(test::readText(folder / "t1.pfm"), test::readText(folder / "t5.pfm"));
    for (const char* bvhSettings :
         {"isa=scalar", "bvh_layout=binary", "bvh_builder=median --set leaf_size=1", "bvh=false"}) {
        run(folder,
            std::string("rayscope render builtin:cornell-area --size 30x30 --spp 3 -o other.pfm --set ") +
                bvhSettings);
        EXPECT_EQ(test::readText(folder / "t1.pfm"), test::readText(folder / "other.pfm")) << bvhSettings;
    }
    run(folder, "rayscope render builtin:cornell-area --size 30x30 --spp 3 --seed 1 -o s.pfm");
    EXPECT_NE(test::readText(folder / "t1.pfm"), test::readText(folder / "s.pfm"));
}

TEST(Render, WritesStatistics) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        run(folder, "rayscope render builtin:teapot --size 40x40 --spp 1 -o a.png --stats s.json").exitCode,
        0);
    const nlohmann::json stats = nlohmann::json::parse(test::readText(folder / "s.json"));
    EXPECT_EQ(stats["bodies"][0]["triangles"], 15704);
    EXPECT_EQ(stats["samples"], 1);
    EXPECT_GT(stats["rays"], 1600);
    EXPECT_EQ(stats["settings"]["spp"], "1");
}

TEST(Render, ShowsProgress) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, "rayscope render builtin:cornell --size 40x40 --spp 1 -o a.png --progress json");
    std::istringstream lines(result.err);
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    EXPECT_EQ(nlohmann::json::parse(last)["progress"], 1.0);
    EXPECT_THAT(
        run(folder, "rayscope render builtin:cornell --size 40x40 --spp 1 -o a.png --progress bar").err,
        HasSubstr("100 %"));
    EXPECT_EQ(run(folder, "rayscope render builtin:cornell --size 40x40 --spp 1 -o a.png -q").err, "");
}

TEST(Render, WritesTheImageAtTheTimeLimit) {
    const TemporaryFolder folder;
    const ProgramResult result = run(
        folder, "rayscope render builtin:cornell-area --size 200x200 --spp 100000 --time-limit 0.5 -o a.png");
    EXPECT_EQ(result.exitCode, 3) << result.err;
    EXPECT_EQ(readImage(folder / "a.png").width, 200);
}

TEST(Render, ALimitThatStopsNothingIsNoFailure) {
    const TemporaryFolder folder;
    // One tile with one sample: not started, in flight or complete when the time is over, depending on the
    // machine.
    const std::string render =
        "rayscope render builtin:cornell-area --set parallelogram_samples=100 --size 32x32 --spp 1 -t 1 ";
    ASSERT_EQ(run(folder, render + "-o whole.pfm").exitCode, 0);
    for (const char* limit : {"0.001", "0.01", "0.03", "0.1", "0.3", "100"}) {
        const ProgramResult result = run(folder, render + "-o limited.pfm --time-limit " + limit);
        const bool isWhole = test::readText(folder / "limited.pfm") == test::readText(folder / "whole.pfm");
        EXPECT_EQ(result.exitCode, isWhole ? 0 : 3) << limit << "\n" << result.err;
        EXPECT_TRUE(isWhole || limit != std::string("100"));
    }
}

TEST(Render, ReachesATargetErrorOrReportsTheLimit) {
    const TemporaryFolder folder;
    const std::string scene = "rayscope render builtin:cornell-area --size 40x40 -o a.exr --stats s.json ";
    const ProgramResult reached = run(folder, scene + "--target-error 0.01 --confidence 0.99 --adaptive");
    EXPECT_EQ(reached.exitCode, 0) << reached.err;
    EXPECT_THAT(reached.err, HasSubstr("target error reached"));
    EXPECT_EQ(readImage(folder / "a.exr").width, 40);
    EXPECT_GE(nlohmann::json::parse(test::readText(folder / "s.json"))["samples"], 16);
    const ProgramResult late = run(folder, scene + "--target-error 1e-9 --time-limit 0.3 --worst-tile");
    EXPECT_EQ(late.exitCode, 3) << late.err;
    EXPECT_THAT(late.err, HasSubstr("stopped by the time limit"));
    const ProgramResult limited = run(folder, scene + "--target-error 1e-9 --spp 20 --metric relmse");
    EXPECT_EQ(limited.exitCode, 3) << limited.err;
    EXPECT_THAT(limited.err, HasSubstr("with 20 samples per pixel"));
    const ProgramResult progress = run(folder, scene + "--target-error 0.001 --progress json");
    EXPECT_THAT(progress.err, HasSubstr("\"remaining_s\""));
    EXPECT_EQ(run(folder, scene + "--target-error 0.01 --metric flip").exitCode, 2);
    EXPECT_EQ(run(folder, scene + "--target-error 0.01 --metric rmsee").exitCode, 2);
    EXPECT_EQ(run(folder, scene + "--target-error 0").exitCode, 1);
    EXPECT_EQ(run(folder, scene + "--target-error 0.1 --confidence 1").exitCode, 1);
}

TEST(Render, RejectsAnUnwritableOutputBeforeRendering) {
    const TemporaryFolder folder;
    for (const char* output : {"nowhere/a.png", "a.xyz", "/proc/a.png"}) {
        const ProgramResult result =
            run(folder, std::string("rayscope render builtin:cornell --spp 1000000 -o ") + output);
        EXPECT_EQ(result.exitCode, 2) << output;
        EXPECT_THAT(result.err, HasSubstr("error:"));
    }
}

TEST(Render, KeepsTheOldFileWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    folder.write("a.pfm", "precious");
    // A limit on the size of files fails the write as a full disk does.
    const ProgramResult result = run(folder, std::string("ulimit -f 4; '") + RAYSCOPE_PROGRAM +
                                                 "' render builtin:cornell --size 100x100 --spp 1 -o a.pfm");
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("a.pfm"));
    EXPECT_EQ(test::readText(folder / "a.pfm"), "precious");
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        files += entry.path().filename() != ".out" && entry.path().filename() != ".err";
    EXPECT_EQ(files, 1);
}

/// A sphere under two lights whose sum overflows.
constexpr const char* kOverflowingScene =
    "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\nlook_at = [0, 0, 0]\n[[sphere]]\ncenter = "
    "[0, 0, 0]\nradius = 1\nmaterial = "
    "\"m\"\n[material.m]\nkd = [1, 1, 1]\n[[light]]\ntype = \"point\"\nposition = [0, 0, "
    "3]\ncolor = [3e38, 0, 0]\n[[light]]\n"
    "type = \"point\"\nposition = [0, 0, 3]\ncolor = [3e38, 0, 0]\n";

TEST(Render, ReportsNonFinitePixels) {
    const TemporaryFolder folder;
    folder.write("s.toml", kOverflowingScene);
    const ProgramResult result = run(folder, "rayscope render s.toml --size 20x20 --spp 1 -o a.exr");
    EXPECT_EQ(result.exitCode, 5) << result.err;
    EXPECT_THAT(result.err, HasSubstr("rayscope probe s.toml --size 20x20 --set spp=1 --pixel "));
    EXPECT_THAT(
        result.err,
        ContainsRegex(
            "in the first, the sum of its 2 terms is .[3-9].*e.38 0 0., which exceeds the range of float"));
    // The command that is named repeats it.
    const std::string command = result.err.substr(result.err.find("rayscope probe"));
    const ProgramResult probe = run(folder, command.substr(0, command.find('\n')));
    EXPECT_EQ(probe.exitCode, 0) << probe.err;
    EXPECT_THAT(probe.out, ContainsRegex("radiance .[3-9].*e.38 0 0."));
    EXPECT_TRUE(std::filesystem::exists(folder / "a.exr"));
}

TEST(Render, NamesAProbeCommandWithTheSettingsOfThePreset) {
    const TemporaryFolder folder;
    folder.write("s.toml", kOverflowingScene);
    const std::string render =
        "rayscope render s.toml --size 8x8 -o a.exr --preset preview --set exposure=0.5 ";
    const ProgramResult result = run(folder, render);
    ASSERT_EQ(result.exitCode, 5) << result.err;
    std::string command = result.err.substr(result.err.find("rayscope probe"));
    command = command.substr(0, command.find('\n'));
    EXPECT_EQ(run(folder, command).exitCode, 0);
    // Rendered with the options of the command, the settings are the same.
    command.replace(command.find("probe"), 5, "render");
    command = command.substr(0, command.find(" --pixel")) + " -o a.exr --dump-settings";
    const std::string settings = run(folder, render + "--dump-settings").out;
    EXPECT_THAT(settings, HasSubstr("exposure = 0.5"));
    EXPECT_EQ(run(folder, command).out, settings);
}

TEST(Render, WritesAovs) {
    const TemporaryFolder folder;
    const std::string render = "rayscope render builtin:cornell-area --size 30x20 --spp 4 -q ";
    EXPECT_EQ(run(folder, render + "-o plain.pfm").exitCode, 0);
    EXPECT_EQ(run(folder, render + "-o a.png -o b.pfm --aov nodes,depth --aov variance").exitCode, 0);
    for (const char* name : {"a.nodes.exr", "a.depth.exr", "a.variance.exr"}) {
        const RgbImage image = readImage((folder / name).string());
        EXPECT_EQ(image.width, 30) << name;
        float highest = 0.0f;
        for (const Rgb& pixel : image.pixels) highest = std::max(highest, pixel.x);
        EXPECT_GT(highest, 0.0f) << name;
    }
    // Counting does not change what is counted.
    EXPECT_EQ(test::readText(folder / "b.pfm"), test::readText(folder / "plain.pfm"));
    const ProgramResult wrong = run(folder, render + "-o c.png --aov dept");
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("'depth'"));
    EXPECT_FALSE(std::filesystem::exists(folder / "c.png"));
}

TEST(Render, AppliesSettingsInOrder) {
    const TemporaryFolder folder;
    folder.write(
        "s.toml",
        "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n[settings]\nmax_depth = 3\nspp = 4\n");
    const ProgramResult result = run(folder, "rayscope render s.toml --dump-settings --set spp=8 -q");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.out, "[settings]\nmax_depth = 3\nspp = 8\n");
}

TEST(Render, PresetsOverrideTheSceneAndSetOverridesPresets) {
    const TemporaryFolder folder;
    folder.write(
        "s.toml",
        "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n[settings]\nspp = 4\nmax_depth = 9\n");
    const ProgramResult result =
        run(folder, "rayscope render s.toml --dump-settings -q --set max_depth=3 --preset preview");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.out, HasSubstr("spp = 1\n"));
    EXPECT_THAT(result.out, HasSubstr("max_depth = 3\n"));
    const ProgramResult wrong = run(folder, "rayscope render s.toml --dump-settings --preset previw");
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("did you mean 'preview'"));
}

TEST(Render, PresetsDependOnTheLensOfTheCameraAndOnMotion) {
    const TemporaryFolder folder;
    const std::string lens = "lens = { f_number = 2, focal_length = 0.1, focus_distance = 3 }\n";
    const auto dumped = [&](const std::string& lensOfFirst, const std::string& motion,
                            const char* more = "") {
        const std::string camera = "[[camera]]\nlook_from = [0, 0, 3]\nlook_at = [0, 0, 0]\n";
        folder.write("s.toml", "version = 1\n" + camera + "name = \"a\"\n" + lensOfFirst + camera +
                                   "name = \"b\"\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n" + motion);
        return run(folder, std::string("rayscope render s.toml --dump-settings -q --preset preview ") + more)
            .out;
    };
    const auto perSide = HasSubstr("parallelogram_samples = 1\n");
    EXPECT_THAT(dumped("", ""), Not(perSide));
    EXPECT_THAT(dumped(lens, ""), perSide);
    EXPECT_THAT(dumped(lens, "", "--camera b"), Not(perSide));
    EXPECT_THAT(dumped("", "motion = [1, 0, 0]\n"), perSide);
    EXPECT_THAT(dumped(lens, "", "--set parallelogram_samples=3"), HasSubstr("parallelogram_samples = 3\n"));
}

TEST(Render, PixelBoundsRenderARegion) {
    const TemporaryFolder folder;
    run(folder, "rayscope render builtin:cornell --size 40x40 --spp 1 -o whole.pfm");
    run(folder, "rayscope render builtin:cornell --size 40x40 --spp 1 --pixelbounds 10,20,5,30 -o part.pfm");
    const RgbImage whole = readImage(folder / "whole.pfm"), part = readImage(folder / "part.pfm");
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(part.at(x, y), x >= 10 && x < 20 && y >= 5 && y < 30 ? whole.at(x, y) : Rgb(0.0f));
}

TEST(Render, OutputsDifferFromInputsAndEachOther) {
    const TemporaryFolder folder;
    folder.write("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::pair<const char*, const char*> commands[] = {
        {"render x.obj --size 8x8 --spp 1 -o a.png --stats x.obj", "'x.obj' is also read by SCENE"},
        {"render x.obj --size 8x8 --spp 1 -o a.png --aov normal -o a.normal.exr",
         "is also written by another option"},
        {"render x.obj --size 8x8 --spp 1 -o a.png --aov normal --stats a.normal.exr",
         "is also written by another option"},
        {"render x.obj --size 8x8 --spp 1 -o - --format png --stats /dev/stdout",
         "the standard output already receives the image"}};
    for (const auto& [command, message] : commands) {
        const ProgramResult result = run(folder, std::string("rayscope ") + command);
        EXPECT_EQ(result.exitCode, 1) << command;
        EXPECT_THAT(result.err, HasSubstr(message)) << command;
    }
    EXPECT_EQ(test::readText(folder / "x.obj").substr(0, 7), "v 0 0 0");
}

}  // namespace
}  // namespace rayscope
