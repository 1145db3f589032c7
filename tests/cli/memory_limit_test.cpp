// Commands that need more memory than they may use: one line that says what needs how much, and no output.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <rayscope/image.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

void expectOutOfMemory(const TemporaryFolder& folder, const std::string& command, const std::string& what) {
    const ProgramResult result = run(folder, command);
    SCOPED_TRACE(command + "\n" + result.err);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("error: out of memory"));
    EXPECT_THAT(result.err, HasSubstr(what));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "o.png"));
    EXPECT_EQ(test::temporaryFiles(folder), 0u);
}

TEST(MemoryLimit, IsCheckedBeforeLargeAllocations) {
    const TemporaryFolder folder;
    folder.write("terrain.toml",
                 "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[[mesh]]\ngenerate = { shape = "
                 "\"terrain\", cells = [4000, 4000] }\n");
    const std::string size = " --memory-limit 300M ";
    expectOutOfMemory(folder, "rayscope render builtin:triangle -o o.png --spp 1 --size 8000x8000" + size,
                      "a film of 8000 x 8000 pixels needs 4.4 GB, but only");
    expectOutOfMemory(folder,
                      "rayscope render builtin:triangle -o o.png --target-error 0.1 --size 8000x8000" + size,
                      "a film of 8000 x 8000 pixels needs 4.1 GB, but only");
    expectOutOfMemory(folder, "rayscope trade builtin:triangle -o t --size 8000x8000 --budget 1" + size,
                      "a film of 8000 x 8000 pixels needs");
    for (const char* command : {"info", "probe --pixel 1,1", "render -o o.png --spp 1", "bench", "lab"})
        expectOutOfMemory(folder, std::string("rayscope ") + command + " terrain.toml" + size,
                          "a terrain of 4000 x 4000 cells needs 768 MB, but only");
}

TEST(MemoryLimit, CoversImagesThatAreRead) {
    const TemporaryFolder folder;
    writeImage((folder / "large.png").string(), RgbImage(3000, 3000));
    expectOutOfMemory(folder, "rayscope compare large.png large.png --memory-limit 90M",
                      "large.png with 3000 x 3000 pixels needs 108 MB");
    folder.write("scene.toml",
                 "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[material.m]\nkd_texture = \"large.png\"\n"
                 "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n");
    expectOutOfMemory(folder, "rayscope info scene.toml --memory-limit 90M", "large.png");
}

TEST(MemoryLimit, CoversFilesThatGrowWhileTheyAreRead) {
    const TemporaryFolder folder;
    std::string vertices, faces;
    for (int i = 0; i < 400000; ++i) vertices += "v 0 0 1\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 400000; ++i) faces += fmt::format("f {} {} {}\n", 3 * i + 1, 3 * i + 2, 3 * i + 3);
    folder.write("big.obj", vertices + faces);
    expectOutOfMemory(folder, "rayscope info big.obj --memory-limit 40M", "big.obj");
    // From a pipe, whose size is not known.
    expectOutOfMemory(
        folder,
        std::string("mkfifo p.toml; { head -c 300000000 /dev/zero | tr '\\0' '#'; } >p.toml 2>.pipe & '") +
            RAYSCOPE_PROGRAM + "' info p.toml --memory-limit 100M",
        "p.toml");
}

TEST(MemoryLimit, SaysWhichLimitOfTheSystemIsTooSmall) {
    const TemporaryFolder folder;
    const std::string program = std::string("'") + RAYSCOPE_PROGRAM + "'";
    const std::string render = program + " render builtin:triangle -o o.png --spp 1 --size 16000x16000";
    if (run(folder, "ulimit -v 3000000; " + program + " --version").exitCode != 0)
        GTEST_SKIP() << "the sanitizer needs more address space";
    expectOutOfMemory(folder, "ulimit -v 3000000; " + render, "(the address space, ulimit -v) are left");
    expectOutOfMemory(folder, "ulimit -d 3000000; " + render, "(the data segment, ulimit -d) are left");
}

TEST(MemoryLimit, IsASizeWithAUnit) {
    const TemporaryFolder folder;
    for (const char* text : {"500", "0M", "-5G", "5X", "all", "nanG"}) {
        const ProgramResult result =
            run(folder, std::string("rayscope info builtin:triangle --memory-limit '") + text + "'");
        EXPECT_EQ(result.exitCode, 1) << text;
        EXPECT_THAT(result.err,
                    HasSubstr("--memory-limit: expected none or a size with a unit, such as 500M"))
            << text;
    }
    for (const char* text : {"none", "2G", "1500MB", "2.5 GiB", "900m"})
        EXPECT_EQ(
            run(folder, std::string("rayscope info builtin:triangle --memory-limit '") + text + "'").exitCode,
            0)
            << text;
}

TEST(MemoryLimit, LeavesTheImageAsItIs) {
    const TemporaryFolder folder;
    const std::string render = "rayscope render builtin:cornell --size 40x40 --spp 2 -q -o ";
    ASSERT_EQ(run(folder, render + "a.pfm --memory-limit 1G").exitCode, 0);
    ASSERT_EQ(run(folder, render + "b.pfm --memory-limit none").exitCode, 0);
    EXPECT_EQ(test::readText(folder / "a.pfm"), test::readText(folder / "b.pfm"));
}

}  // namespace
}  // namespace rayscope
