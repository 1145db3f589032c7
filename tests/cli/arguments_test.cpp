#include "cli/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "cli/commands.h"

namespace rayscope::cli {
namespace {

using Arguments = std::vector<std::string>;
using testing::ElementsAre;
using testing::HasSubstr;

/// A command with an option of each kind.
struct Sample {
    std::string scene, output, ray;
    std::vector<std::string> settings;
    int threads = 0;
    bool quiet = false, any = false;

    bool parse(const Arguments& arguments) {
        OptionList list;
        list.add("SCENE", &scene, "").required();
        list.add("-o,--output", &output, "").required();
        list.add("-t,--threads", &threads, "").from(0, 8);
        list.add("-D,--set", &settings, "").form("KEY=VALUE");
        list.add("--ray", &ray, "").valueOptional("0");
        list.add("-q,--quiet", &quiet, "");
        list.add("-a,--any", &any, "");
        return parseOptions({"cast", "", nullptr}, list, arguments);
    }
    std::string errorOf(const Arguments& arguments) {
        try {
            parse(arguments);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    }
};

TEST(Arguments, AllWaysToGiveAValue) {
    for (const Arguments& arguments :
         {Arguments{"s", "-o", "f", "-t", "4"}, Arguments{"-o=f", "-t4", "s"},
          Arguments{"--output", "f", "s", "--threads=4"}, Arguments{"-of", "--threads", "+4", "s"},
          Arguments{"-t=4", "-of", "--", "s"}}) {
        Sample sample;
        EXPECT_TRUE(sample.parse(arguments));
        EXPECT_EQ(sample.scene, "s");
        EXPECT_EQ(sample.output, "f");
        EXPECT_EQ(sample.threads, 4);
    }
}

TEST(Arguments, FlagsRepeatsAndImpliedValues) {
    Sample sample;
    EXPECT_TRUE(sample.parse({"-qao", "f", "s", "-D", "a=1", "--set", "b=-2", "-q", "--ray"}));
    EXPECT_TRUE(sample.quiet && sample.any);
    EXPECT_THAT(sample.settings, ElementsAre("a=1", "b=-2"));
    EXPECT_EQ(sample.ray, "0");
    Sample named;
    EXPECT_TRUE(named.parse({"s", "-o", "f", "--ray", "s3", "-D", "x"}));
    EXPECT_EQ(named.ray, "s3");
}

TEST(Arguments, NamesMayBeginWithADash) {
    Sample sample;
    EXPECT_TRUE(sample.parse({"-o", "-f", "--", "-x.obj"}));
    EXPECT_EQ(sample.scene, "-x.obj");
    EXPECT_EQ(sample.output, "-f");
}

TEST(Arguments, ErrorsNameWhatIsWrong) {
    const std::pair<Arguments, const char*> cases[] = {
        {{}, "SCENE is required"},
        {{"s"}, "--output is required"},
        {{"s", "-o"}, "--output: a value is missing; expected TEXT"},
        {{"s", "-o", "f", "-t"}, "--threads: a value is missing; expected an integer from 0 to 8"},
        {{"s", "-t", "-o", "f"}, "--threads: a value is missing"},
        {{"s", "-o", "--threads=4"}, "--output: a value is missing"},
        {{"s", "-o", "f", "-t", "-5"}, "--threads: expected an integer from 0 to 8, got '-5'"},
        {{"s", "-o", "f", "-o", "g"}, "--output is given twice"},
        {{"s", "-t", "1", "--threads=1"}, "--threads is given twice"},
        {{"s", "s2"}, "unexpected argument 's2' after SCENE 's'"},
        {{"s", "--outptu", "f"}, "unknown option '--outptu' of 'cast' (did you mean '--output'?)"},
        {{"s", "--outptu=f"}, "unknown option '--outptu' of 'cast' (did you mean '--output'?)"},
        {{"s", "-x"}, "unknown option '-x' of 'cast'"},
        {{"-x.obj"}, "unknown option '-x.obj' of 'cast'; for a file of this name write './-x.obj'"},
        {{"s", "-5"}, "unknown option '-5' of 'cast'"},
        {{"s", "-qx"}, "unknown option '-x' of 'cast'"},
        {{"s", "--quiet=1"}, "--quiet: takes no value"},
        {{""}, "an argument is empty"},
        {{"s", "-o", ""}, "--output: the value is empty"},
        {{"s", "--output="}, "--output: the value is empty"},
        {{"s", "-D", ""}, "--set: the value is empty"},
        {{"s", "--\033[2J"}, "unknown option '--\\x1B[2J' of 'cast'"},
    };
    for (const auto& [arguments, expected] : cases)
        EXPECT_THAT(Sample().errorOf(arguments), HasSubstr(expected));
    EXPECT_LE(Sample().errorOf({"--" + std::string(100000, 'y')}).size(), 200u);
}

TEST(Arguments, HelpComesFirst) {
    for (const char* help : {"--help", "-h"}) EXPECT_FALSE(Sample().parse({"s", help, "--unknown"}));
}

std::string commandErrorOf(const Arguments& arguments) {
    try {
        findCommand(commandTable(), arguments);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Arguments, CommandsAreFoundByName) {
    for (const Command& command : commandTable()) {
        const CommandArguments found = findCommand(commandTable(), {std::string(command.name), "x"});
        ASSERT_NE(found.command, nullptr);
        EXPECT_EQ(found.command->name, command.name);
        EXPECT_THAT(found.rest, ElementsAre("x"));
    }
    EXPECT_TRUE(findCommand(commandTable(), {"--version"}).wantsVersion);
    EXPECT_TRUE(findCommand(commandTable(), {"--help"}).wantsHelp);
}

TEST(Arguments, UnknownCommandsAreNamed) {
    EXPECT_EQ(commandErrorOf({"rendr", "x.obj"}), "unknown command 'rendr' (did you mean 'render'?)");
    EXPECT_EQ(commandErrorOf({"xyzzy"}), "unknown command 'xyzzy', and there is no file of this name");
    EXPECT_EQ(commandErrorOf({"cornell"}),
              "unknown command 'cornell' (the built-in scene is 'builtin:cornell')");
    EXPECT_THAT(commandErrorOf({""}), HasSubstr("an argument is empty"));
    EXPECT_EQ(commandErrorOf({"--size", "8x8", "render", "x.obj"}),
              "the command comes first: rayscope render …");
}

TEST(Arguments, AnyFileMayBeAScene) {
    const auto named = [](const char* name) { return commandTable().front().name == std::string_view(name); };
    if (!named("view")) GTEST_SKIP() << "built without the window";
    for (const char* scene : {"x.obj", "folder/scene", "builtin:cornell", "missing.toml"}) {
        const CommandArguments found = findCommand(commandTable(), {scene});
        EXPECT_EQ(found.command->name, "view") << scene;
        EXPECT_THAT(found.rest, ElementsAre(scene));
    }
}

}  // namespace
}  // namespace rayscope::cli
