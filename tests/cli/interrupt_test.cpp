// Signals while a command loads and renders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include <rayscope/image.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kInterruptedProgram = std::string("'") + RAYSCOPE_PROGRAM + "'";

/// Interrupts the program as soon as its messages contain `text`. Shells ignore SIGINT in the background.
ProgramResult interruptAfter(const TemporaryFolder& folder, const std::string& arguments,
                             const std::string& text) {
    return run(folder,
               "env --default-signal=INT " + kInterruptedProgram + " " + arguments +
                   " 2>messages & p=$!; until grep -q '" + text +
                   "' messages || ! kill -0 $p; do sleep 0.05; done; kill -INT $p; wait $p; s=$?; cat "
                   "messages >&2; exit $s");
}

TEST(Interrupt, WritesTheImage) {
    const TemporaryFolder folder;
    const ProgramResult result = interruptAfter(
        folder, "render builtin:cornell-area --size 100x100 --spp 1000000 --progress json -o a.png",
        "\"samples\":[1-9]");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_EQ(readImage(folder / "a.png").width, 100);
}

TEST(Interrupt, EndsALongLoadThatShowsItsSteps) {
    const TemporaryFolder folder;
    // A scene file that does not end.
    run(folder,
        "mkfifo s.toml; { while head -c 70000 /dev/zero | tr '\\0' '#'; do sleep 0.3; done; } "
        "2>/dev/null >s.toml & true");
    const ProgramResult result =
        interruptAfter(folder, "render s.toml --progress json -o a.png", "\"step\":\"reading s.toml\"");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

/// A scene file that takes long to read: a pipe whose blocks arrive after 1.2 and after 3.7 seconds. The
/// signal comes between them.
ProgramResult interruptSlowLoad(const TemporaryFolder& folder, const std::string& arguments) {
    const std::string block = "head -c 70000 /dev/zero | tr '\\0' '#'";
    return run(folder, "rm -f s.toml; mkfifo s.toml; { sleep 1.2; " + block + "; sleep 2.5; " + block +
                           "; } >s.toml & timeout --foreground --preserve-status -s INT 2.5 " +
                           kInterruptedProgram + " " + arguments);
}

TEST(Interrupt, EndsTheLoadOfEveryCommand) {
    const TemporaryFolder folder;
    for (const char* command : {"info", "probe --pixel 1,1", "trade", "lab", "bench"}) {
        const ProgramResult result = interruptSlowLoad(folder, std::string(command) + " s.toml");
        EXPECT_EQ(result.exitCode, 130) << command << result.err;
        EXPECT_EQ(result.out, "") << command;
    }
}

TEST(Interrupt, EndsALoadThatCannotBeStopped) {
    const TemporaryFolder folder;
    // Opening a pipe that nobody writes to blocks.
    for (const char* arguments :
         {"info s.toml", "render s.toml -o a.png", "cast s.toml --rays s.toml -o h"}) {
        const ProgramResult result = run(
            folder, "rm -f s.toml; mkfifo s.toml; timeout --foreground --preserve-status -k 60 -s INT 1 " +
                        kInterruptedProgram + " " + arguments);
        EXPECT_EQ(result.exitCode, 130) << arguments << "\n" << result.err;
    }
}

bool hasSetting(const std::string& png, const std::string& name, const std::string& value) {
    return test::readText(png).find("setting." + name + '\0' + value) != std::string::npos;
}

TEST(Interrupt, LeavesOutBloomThatTakesLong) {
    const TemporaryFolder folder;
    const ProgramResult result =
        interruptAfter(folder,
                       "render builtin:triangle --size 2000x2000 --spp 1000000 --set bloom=true --set "
                       "bloom_size=500 --progress json -o a.ppm -o a.png",
                       "\"samples\"");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_THAT(result.err, HasSubstr("interrupted: the image is written without bloom"));
    EXPECT_EQ(readImage(folder / "a.ppm").width, 2000);
    EXPECT_EQ(readImage(folder / "a.ppm").pixels, readImage(folder / "a.png").pixels);
    // The metadata describes the image that is written.
    EXPECT_TRUE(hasSetting(folder / "a.png", "bloom", "false"));
}

TEST(Interrupt, AppliesBloomThatTakesNoTime) {
    const TemporaryFolder folder;
    const ProgramResult result = interruptAfter(
        folder,
        "render builtin:triangle --size 64x64 --spp 1000000 --set bloom=true --progress json -o a.png",
        "\"samples\":[1-9]");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_THAT(result.err, testing::Not(HasSubstr("without bloom")));
    EXPECT_TRUE(hasSetting(folder / "a.png", "bloom", "true"));
}

TEST(Interrupt, SaysSoIfTheImageStillTakesLong) {
    const TemporaryFolder folder;
    run(folder, "mkfifo a.ppm; { sleep 6; cat a.ppm >copy.ppm; } & true");
    const ProgramResult result = interruptAfter(
        folder, "render builtin:triangle --size 200x200 --spp 1000000 --progress json -o a.ppm",
        "\"samples\"");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_THAT(result.err, HasSubstr("interrupted: the image so far is processed and written"));
    EXPECT_EQ(readImage(folder / "copy.ppm").width, 200);
}

}  // namespace
}  // namespace rayscope
