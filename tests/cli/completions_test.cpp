// The completions in the shells themselves; skipped for shells that are not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

bool isInstalled(const TemporaryFolder& folder, const std::string& tool) {
    return run(folder, "command -v " + tool).exitCode == 0;
}

/// What a shell offers after this line, one word per line.
using Offers = std::string(const TemporaryFolder& folder, const std::string& line);

std::string bashOffers(const TemporaryFolder& folder, const std::string& line) {
    folder.write("try.sh",
                 "source ./script\ncompopt() { :; }\nCOMP_LINE='" + line +
                     "'\nCOMP_POINT=${#COMP_LINE}\n_rayscope\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
    return run(folder, "rayscope completions bash >script && bash try.sh").out;
}

std::string fishOffers(const TemporaryFolder& folder, const std::string& line) {
    return run(folder,
               "rayscope completions fish >script && HOME=$PWD fish --no-config -c 'source script; "
               "complete -C \"" +
                   line + "\"' | cut -f 1")
        .out;
}

void expectCompletions(const TemporaryFolder& folder, Offers offers) {
    folder.write("my-scene.toml", "");
    EXPECT_THAT(offers(folder, "rayscope re"), HasSubstr("render"));
    EXPECT_THAT(offers(folder, "rayscope re"), Not(HasSubstr("probe")));
    EXPECT_THAT(offers(folder, "rayscope render builtin:cornell --pre"), HasSubstr("--preset"));
    EXPECT_THAT(offers(folder, "rayscope probe --pre"), HasSubstr("--preset"));
    EXPECT_THAT(offers(folder, "rayscope compare --pre"), Not(HasSubstr("--preset")));
    EXPECT_THAT(offers(folder, "rayscope render --preset fi"), HasSubstr("final"));
    EXPECT_THAT(offers(folder, "rayscope render --preset fi"), Not(HasSubstr("preview")));
    EXPECT_THAT(offers(folder, "rayscope render my"), HasSubstr("my-scene.toml"));
    EXPECT_THAT(offers(folder, "rayscope render -o my"), HasSubstr("my-scene.toml"));
    EXPECT_THAT(offers(folder, "rayscope render builtin:corn"), HasSubstr("cornell-area"));
    EXPECT_THAT(offers(folder, "rayscope render -D max_d"), HasSubstr("max_depth="));
    EXPECT_THAT(offers(folder, "rayscope completions z"), HasSubstr("zsh"));
}

TEST(Completions, OfBash) {
    const TemporaryFolder folder;
    if (!isInstalled(folder, "bash")) GTEST_SKIP() << "bash is not installed";
    expectCompletions(folder, bashOffers);
    // The shell replaces only what follows the last = or :.
    EXPECT_THAT(bashOffers(folder, "rayscope render --preset=fi"), testing::StrEq("final\n"));
    EXPECT_THAT(bashOffers(folder, "rayscope render --set isa=s"), testing::StrEq("scalar\nsse2\n"));
    EXPECT_THAT(bashOffers(folder, "rayscope info builtin:tea"), testing::StrEq("teapot\n"));
    EXPECT_THAT(bashOffers(folder, "rayscope render --fov "), testing::StrEq("\n"));
}

TEST(Completions, OfFish) {
    const TemporaryFolder folder;
    if (!isInstalled(folder, "fish")) GTEST_SKIP() << "fish is not installed";
    expectCompletions(folder, fishOffers);
}

TEST(Completions, OfZshAreValid) {
    const TemporaryFolder folder;
    if (!isInstalled(folder, "zsh")) GTEST_SKIP() << "zsh is not installed";
    folder.write("try.zsh",
                 "compdef() { : }\nsource ./script\n_arguments() { printf '%s\\n' $@ }\n"
                 "words=(rayscope render x) CURRENT=3\n_rayscope\n");
    const test::ProgramResult result = run(folder, "rayscope completions zsh >script && zsh -f try.zsh");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("\n(--preset)--preset=["));
    EXPECT_THAT(result.out, HasSubstr(":TEXT:{ compadd -- preview balanced final reference; }\n"));
    EXPECT_THAT(result.out, HasSubstr("\n*-o+["));
    EXPECT_THAT(result.out, HasSubstr("\n:SCENE:{ compadd -- builtin\\:"));
}

}  // namespace
}  // namespace rayscope
