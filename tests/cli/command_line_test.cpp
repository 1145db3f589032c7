#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/settings.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(CommandLine, HelpAndVersion) {
    const TemporaryFolder folder;
    EXPECT_EQ(run(folder, "rayscope --help").exitCode, 0);
    for (const char* command : {"render", "probe", "bench", "cast", "trade", "compare", "info", "settings"}) {
        EXPECT_THAT(run(folder, "rayscope --help").out, HasSubstr(command));
        EXPECT_EQ(run(folder, std::string("rayscope ") + command + " --help").exitCode, 0);
    }
    const ProgramResult version = run(folder, "rayscope --version");
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_THAT(version.out,
                testing::MatchesRegex("rayscope [0-9.]+\ncompiler: .*[0-9], .*\n"
                                      "kernels: scalar.*; auto selects .*\nlibraries: fmt [0-9].*\n"));
    for (const char* library :
         {"GLM", "JSON for Modern C++", "libjpeg", "libpng", "oneTBB", "OpenEXR", "toml++", "zlib"})
        EXPECT_THAT(version.out, HasSubstr(std::string(library) + " "));
}

TEST(CommandLine, UsageErrorsExitWithOneAndSuggestTheNearestName) {
    const TemporaryFolder folder;
    const ProgramResult unknown = run(folder, "rayscope render builtin:triangle -o a.png --sizee 10x10");
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_THAT(unknown.err, HasSubstr("'--sizee'"));
    EXPECT_THAT(unknown.err, HasSubstr("did you mean '--size'"));
    for (const char* arguments :
         {"render", "render builtin:triangle", "render builtin:triangle -o a.png --size 10",
          "render builtin:triangle -o a.png --size 0x10", "render builtin:triangle -o a.png --set spp",
          "render builtin:triangle -o a.png --look-from 1,2",
          "render builtin:triangle -o a.png --pixelbounds 5,5,0,3", "probe builtin:triangle",
          "probe builtin:triangle --pixel 9999,0", "info", "render builtin:triangle -o a.png --threads -1"})
        EXPECT_EQ(run(folder, std::string("rayscope ") + arguments).exitCode, 1) << arguments;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(CommandLine, InputErrorsExitWithTwoAndSuggestTheNearestName) {
    const TemporaryFolder folder;
    const ProgramResult setting = run(folder, "rayscope render builtin:triangle -o a.png --set max_dept=3");
    EXPECT_EQ(setting.exitCode, 2);
    EXPECT_THAT(setting.err, HasSubstr("did you mean 'max_depth'"));
    const ProgramResult range = run(folder, "rayscope render builtin:triangle -o a.png --set max_depth=17");
    EXPECT_EQ(range.exitCode, 2);
    EXPECT_THAT(range.err, HasSubstr("from 0 to 16"));
    EXPECT_EQ(run(folder, "rayscope info missing.toml").exitCode, 2);
    const ProgramResult scene = run(folder, "rayscope info builtin:cornel");
    EXPECT_EQ(scene.exitCode, 2);
    EXPECT_THAT(scene.err, HasSubstr("cornell"));
    EXPECT_EQ(run(folder, "rayscope render builtin:triangle -o a.png --camera side").exitCode, 2);
}

TEST(CommandLine, SceneErrorsHaveAPosition) {
    const TemporaryFolder folder;
    folder.write("s.toml", "version = 1\n\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    const ProgramResult result = run(folder, "rayscope render s.toml -o a.png");
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("s.toml:4:1: error:"));
    EXPECT_THAT(result.err, HasSubstr("center"));
}

TEST(CommandLine, SettingsListsEveryRow) {
    const TemporaryFolder folder;
    const nlohmann::json list = nlohmann::json::parse(run(folder, "rayscope settings --json").out);
    EXPECT_EQ(list.size(), settingKeys().size());
    const std::string text = run(folder, "rayscope settings").out;
    for (const std::string_view key : settingKeys()) EXPECT_THAT(text, HasSubstr(std::string(key)));
}

TEST(CommandLine, InfoPrintsContentsRequirementsAndLint) {
    const TemporaryFolder folder;
    const nlohmann::json info =
        nlohmann::json::parse(run(folder, "rayscope info builtin:cornell-area --json").out);
    EXPECT_GT(info["triangles"], 10);
    EXPECT_FALSE(info["requirements"].empty());
    const ProgramResult list = run(folder, "rayscope info --list");
    for (const char* name : {"triangle", "cornell-area", "ten-million"})
        EXPECT_THAT(list.out, HasSubstr(name));
}

TEST(CommandLine, ProbePrintsTheTraversalOfARay) {
    const TemporaryFolder folder;
    const std::string probe = "rayscope probe builtin:cornell --size 40x40 --pixel 20,25 ";
    const ProgramResult camera = run(folder, probe + "--traversal --json tree.json");
    EXPECT_EQ(camera.exitCode, 0) << camera.err;
    EXPECT_THAT(camera.out, HasSubstr("closest hit in the"));
    const nlohmann::json j = nlohmann::json::parse(test::readText(folder / "tree.json"));
    EXPECT_EQ(j["traversal"][0]["hit"]["primitive"], j["nodes"][0]["hit"]["primitive"]);
    EXPECT_THAT(run(folder, probe + "--traversal s0").out, HasSubstr("any hit in the"));
    const ProgramResult wide = run(folder, probe + "--traversal --layout wide --json wide.json");
    EXPECT_THAT(wide.out, HasSubstr("in the wide tree of motion group 0"));
    const nlohmann::json w = nlohmann::json::parse(std::ifstream(folder.path() / "wide.json"));
    EXPECT_EQ(w["traversal"][0]["layout"], "wide");
    EXPECT_EQ(w["traversal"][0]["hit"], j["traversal"][0]["hit"]);
    EXPECT_THAT(run(folder, probe + "--traversal --set bvh=false").out, HasSubstr("no BVH"));
    for (const char* wrong : {"99", "s99", "x", "-1", "1x", "s"})
        EXPECT_EQ(run(folder, probe + "--traversal " + wrong).exitCode, 1) << wrong;
}

TEST(CommandLine, ProbePrintsADiagnosis) {
    const TemporaryFolder folder;
    folder.write("dark.toml",
                 "version = 1\n[[camera]]\nlook_from = [0, 0, 3]\nlook_at = [0, 0, 0]\n[[sphere]]\ncenter = "
                 "[0, 0, 0]\n"
                 "radius = 1\nmaterial = \"m\"\n[material.m]\nkd = [1, 1, 1]\n");
    const std::string probe = "rayscope probe dark.toml --size 21x21 --explain --json tree.json --pixel ";
    const ProgramResult dark = run(folder, probe + "10,10");
    EXPECT_EQ(dark.exitCode, 0) << dark.err;
    EXPECT_THAT(dark.out, HasSubstr("black, no light: The scene has no light."));
    EXPECT_THAT(dark.out, HasSubstr("see sample 0, ray 0"));
    const nlohmann::json j = nlohmann::json::parse(test::readText(folder / "tree.json"));
    EXPECT_EQ(j["explanation"][0]["cause"], "no light");
    EXPECT_EQ(j["explanation"][0]["rays"][0]["sample"], 0);
    EXPECT_THAT(run(folder, probe + "0,0").out, HasSubstr("black, nothing hit"));
}

TEST(CommandLine, ProbePrintsTheRayTree) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, "rayscope probe builtin:cornell --size 40x40 --pixel 20,20 --json tree.json");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.out, HasSubstr("camera ray"));
    const nlohmann::json tree = nlohmann::json::parse(test::readText(folder / "tree.json"));
    EXPECT_GE(tree["nodes"].size(), 1u);
}

}  // namespace
}  // namespace rayscope
