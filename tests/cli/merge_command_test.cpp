// `render --part` and `merge` against a single run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kSame = " builtin:cornell --size 100x70 --spp 2 --seed 5 --set bloom=true -q ";

void renderParts(const TemporaryFolder& folder, int parts, const std::string& options = kSame) {
    for (int part = 1; part <= parts; ++part) {
        const ProgramResult result = run(
            folder,
            fmt::format("rayscope render {} --part {}/{} --part-file {}.rpart", options, part, parts, part));
        ASSERT_EQ(result.exitCode, 0) << result.err;
    }
}

std::string filesOf(int parts) {
    std::string files;
    for (int part = parts; part >= 1; --part) files += fmt::format(" {}.rpart", part);
    return files;
}

void expectError(const TemporaryFolder& folder, const std::string& files, const std::string& text,
                 const std::string& options = kSame) {
    const ProgramResult result = run(folder, "rayscope merge " + options + files + " -o wrong.exr");
    EXPECT_EQ(result.exitCode, 2) << text;
    EXPECT_THAT(result.err, HasSubstr(text));
    EXPECT_EQ(run(folder, "test -e wrong.exr").exitCode, 1);
}

TEST(MergeCommand, HasTheBitsOfASingleRun) {
    const TemporaryFolder folder;
    ASSERT_EQ(run(folder, "rayscope render" + kSame + "-o one.exr -o one.png").exitCode, 0);
    for (const int parts : {1, 2, 3, 7, 14}) {  // there are 12 tiles
        renderParts(folder, parts);
        const ProgramResult result =
            run(folder, "rayscope merge" + kSame + filesOf(parts) + " -o merged.exr -o merged.png");
        ASSERT_EQ(result.exitCode, 0) << result.err;
        for (const std::string suffix : {".exr", ".png"})
            EXPECT_EQ(test::readText(folder / ("merged" + suffix)), test::readText(folder / ("one" + suffix)))
                << parts;
    }
}

TEST(MergeCommand, TakesTheRegionFromTheParts) {
    const TemporaryFolder folder;
    const std::string region = "--pixelbounds 10,90,5,60";
    ASSERT_EQ(run(folder, "rayscope render" + kSame + region + " -o one.exr").exitCode, 0);
    renderParts(folder, 2, kSame + region);
    const ProgramResult result = run(folder, "rayscope merge" + kSame + "1.rpart 2.rpart -o merged.exr");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(test::readText(folder / "merged.exr"), test::readText(folder / "one.exr"));
}

TEST(MergeCommand, NamesWhatIsMissingOrDoesNotBelong) {
    const TemporaryFolder folder;
    renderParts(folder, 4);
    expectError(folder, "1.rpart 2.rpart 3.rpart", "part 4 of 4 is missing");
    expectError(folder, "3.rpart 2.rpart 3.rpart", "parts 1 and 4 of 4 are missing");
    const std::string all = filesOf(4);
    expectError(folder, all, "has seed 5, not 0", " builtin:cornell --size 100x70 --spp 2 -q ");
    expectError(folder, all, "has samples per pixel: 2, not 3",
                " builtin:cornell --size 100x70 --spp 3 --seed 5 -q ");
    expectError(folder, all, "is of 100 x 70 pixels, not 64 x 64",
                " builtin:cornell --size 64x64 --spp 2 --seed 5 -q ");
    expectError(folder, all, "another scene, camera or settings",
                " builtin:cornell --size 100x70 --spp 2 --seed 5 --fov 30 -q ");
}

TEST(MergeCommand, RefusesDamagedFiles) {
    const TemporaryFolder folder;
    renderParts(folder, 2);
    const std::string part = test::readText(folder / "2.rpart");
    folder.write("short", part.substr(0, part.size() - 1));
    expectError(folder, "1.rpart short", "is incomplete");
    folder.write("long", part + "x");
    expectError(folder, "1.rpart long", "more bytes");
    std::string changed = part;
    changed[part.size() / 2] ^= 1;
    folder.write("changed", changed);
    expectError(folder, "1.rpart changed", "is damaged");
    folder.write("version", "rayscope part 2" + part.substr(15));
    expectError(folder, "1.rpart version", "another version");
    folder.write("text", "a text\n");
    expectError(folder, "1.rpart text", "is not a part of an image");
    expectError(folder, "1.rpart none", "none");
}

TEST(MergeCommand, RenderRefusesContradictoryOptions) {
    const TemporaryFolder folder;
    for (const std::string options :
         {"--part 1/2", "--part-file a.rpart", "--part 3/2 --part-file a.rpart",
          "--part 0/2 --part-file a.rpart", "--part 1/2 --part-file a.rpart -o a.exr"})
        EXPECT_EQ(run(folder, "rayscope render" + kSame + options).exitCode, 1) << options;
}

}  // namespace
}  // namespace rayscope
