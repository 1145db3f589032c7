// Full disks, closed streams, signals: what can be written is written, and the exit code says what was lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::temporaryFiles;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kQuotedProgram = std::string("'") + RAYSCOPE_PROGRAM + "'";
const std::string kRender = kQuotedProgram + " render builtin:cornell --size 16x16 --spp 1 ";

TEST(StandardStreams, AFullStandardOutputIsAnError) {
    const TemporaryFolder folder;
    ASSERT_EQ(run(folder, kRender + "-o a.pfm").exitCode, 0);
    for (const char* arguments :
         {"--help", "--version", "render --help", "info --list", "info builtin:triangle",
          "info builtin:triangle --json", "probe builtin:triangle --size 8x8 --pixel 4,4",
          "compare a.pfm a.pfm", "settings", "settings --json", "settings --markdown",
          "render builtin:triangle --dump-settings --set spp=3",
          "render builtin:triangle --size 8x8 --spp 1 -o - --format pfm",
          "lab --quick --rays 10 builtin:triangle -q"}) {
        const ProgramResult result = run(folder, kQuotedProgram + " " + arguments + " >/dev/full");
        EXPECT_EQ(result.exitCode, 2) << arguments;
        EXPECT_EQ(result.err, "error: the standard output cannot be written: No space left on device\n")
            << arguments;
    }
}

TEST(StandardStreams, MessagesThatCannotBeWrittenAreDropped) {
    const TemporaryFolder folder;
    for (const char* streams : {"2>/dev/full", "2>&-", "2>/dev/null 1>&-", "<&- 2>&-", "<&- >&- 2>&-"}) {
        std::filesystem::remove(folder / "a.pfm");
        const ProgramResult result = run(folder, kRender + "-o a.pfm --progress json " + streams);
        EXPECT_EQ(result.exitCode, 0) << streams;
        EXPECT_EQ(readImage((folder / "a.pfm").string()).width, 16) << streams;
        EXPECT_EQ(run(folder, kQuotedProgram + " render missing.toml -o a.pfm " + streams).exitCode, 2)
            << streams;
        EXPECT_EQ(run(folder, kQuotedProgram + " rendr " + streams).exitCode, 1) << streams;
    }
    EXPECT_EQ(run(folder, kQuotedProgram + " info builtin:triangle >&-").exitCode, 2);
}

TEST(StandardStreams, AClosedPipeEndsQuietly) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, "bash -c \"set -o pipefail; " + std::string(RAYSCOPE_PROGRAM) + " settings | true\"");
    EXPECT_TRUE(result.exitCode == 141 || result.exitCode == 0) << result.exitCode;
    EXPECT_EQ(result.err, "");
    // The reader of the progress is gone, and the image is written.
    const ProgramResult progress =
        run(folder, "bash -c \"" + std::string(RAYSCOPE_PROGRAM) +
                        " render builtin:cornell --size 60x60 --spp 64 --progress json -o "
                        "p.pfm 2> >(exec true)\"");
    EXPECT_EQ(progress.exitCode, 0);
    EXPECT_EQ(readImage((folder / "p.pfm").string()).width, 60);
}

TEST(StandardStreams, ClosedDescriptorsDoNotGetIntoOutputFiles) {
    const TemporaryFolder folder;
    folder.write("n.obj", "l 1 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("z.rays", std::string(3200, '\0'));
    const ProgramResult result = run(folder, kQuotedProgram + " cast n.obj --rays z.rays -o h.hits <&- 2>&-");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(test::readText(folder / "h.hits").size(), 1600u);
}

TEST(StandardStreams, TheImageGoesToTheStandardOutput) {
    const TemporaryFolder folder;
    for (const char* format : {"png", "exr", "pfm", "hdr"}) {
        const std::string name = std::string("a.") + format;
        ASSERT_EQ(run(folder, kRender + "-o " + name).exitCode, 0);
        EXPECT_EQ(run(folder, kRender + "-o - --format " + format + " >piped").exitCode, 0);
        EXPECT_EQ(test::readText(folder / "piped"), test::readText(folder / name)) << format;
    }
    for (const char* wrong : {"-o -", "-o a.png --format png", "-o - --format gif", "-o - -o - --format png",
                              "-o /dev/stdout", "-o - --format png --aov depth"})
        EXPECT_EQ(run(folder, kRender + wrong).exitCode, 1) << wrong;
}

TEST(StandardStreams, OneFailingOutputLeavesTheOthers) {
    const TemporaryFolder folder;
    // A limit on the size of files fails the large ones as a full disk does.
    const ProgramResult result = run(folder, "ulimit -f 8; " + kQuotedProgram +
                                                 " render builtin:cornell --size 64x64 --spp 1 -o a.pfm -o "
                                                 "b.png -o c.pfm --aov depth --stats s.json");
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr("a.pfm: error: cannot be written"));
    EXPECT_THAT(result.err, HasSubstr("c.pfm: error: cannot be written"));
    EXPECT_EQ(readImage((folder / "b.png").string()).width, 64);
    EXPECT_NE(test::readText(folder / "s.json"), "");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.pfm"));
    EXPECT_EQ(temporaryFiles(folder), 0u);
}

TEST(StandardStreams, DestinationsAreCheckedBeforeTheWork) {
    const TemporaryFolder folder;
    folder.write("file", "");
    const std::string endless = "render builtin:cornell --spp 1000000 --size 100x100 ";
    const std::pair<std::string, int> commands[] = {
        {endless + "-o a.png --stats no/s.json", 2},
        {endless + "-o a.png -o no/a.png", 2},
        {endless + "-o a.png --stats a.png", 1},
        {endless + "-o a.png --stats ./a.png", 1},
        {endless + "-o a.png -o a.png", 1},
        {endless + "-o a.png --stats -", 1},
        {endless + "-o a.png --stats file/s.json", 2},
        {endless + "-o a.png --metric rmsee", 2},
        {"trade builtin:triangle --budget 1000 -o file", 2},
        {"trade builtin:triangle --budget 1000 -o /proc/x", 2},
        {"lab builtin:monkey -o file", 2},
        {"bench builtin:dragon --rounds 1000 --json no/b.json", 2},
        {"probe builtin:ten-million --pixel 1,1 --json no/p.json", 2},
        {"cast builtin:ten-million --rays /dev/zero -o no/h.hits", 2},
        {"compare missing.png missing.png -o no/d.png", 2},
        {"compare missing.png missing.png --map m.xyz", 2},
    };
    for (const auto& [arguments, expected] : commands) {
        const ProgramResult result = run(folder, "timeout 20 " + kQuotedProgram + " " + arguments);
        EXPECT_EQ(result.exitCode, expected) << arguments << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: ")) << arguments;
    }
}

TEST(StandardStreams, SignalsLeaveNoTemporaryFiles) {
    const TemporaryFolder folder;
    folder.write("z.rays", std::string(std::size_t{64} << 20, '\0'));
    for (const char* signals : {"INT", "TERM", "HUP", "INT TERM", "HUP HUP", "TERM INT"}) {
        const ProgramResult result = run(
            folder, "bash -c '" + std::string(RAYSCOPE_PROGRAM) +
                        " cast builtin:cornell --rays z.rays -o a.hits -q -t 1 & p=$!; sleep 0.3; for s in " +
                        signals + "; do kill -$s $p; done; wait $p'");
        EXPECT_TRUE(result.exitCode == 130 || result.exitCode == 0) << signals << ": " << result.exitCode;
        EXPECT_EQ(temporaryFiles(folder), 0u) << signals;
    }
}

TEST(StandardStreams, EverySignalWritesTheImage) {
    const TemporaryFolder folder;
    for (const char* signal : {"INT", "TERM", "HUP"}) {
        std::filesystem::remove(folder / "a.png");
        const ProgramResult result =
            run(folder, std::string("timeout --foreground --preserve-status -s ") + signal + " 1 " +
                            kQuotedProgram +
                            " render builtin:cornell-area --size 100x100 --spp 1000000 -o a.png");
        EXPECT_EQ(result.exitCode, 130) << signal;
        EXPECT_EQ(readImage((folder / "a.png").string()).width, 100) << signal;
    }
    // As in a background job of a shell without job control.
    const ProgramResult ignored = run(
        folder,
        "bash -c 'trap \"\" INT; " + std::string(RAYSCOPE_PROGRAM) +
            " render builtin:cornell --size 100x100 --spp 30 -o b.png -q & p=$!; sleep 0.2; kill -INT $p; "
            "wait $p'");
    EXPECT_EQ(ignored.exitCode, 0);
}

TEST(StandardStreams, LackOfMemoryIsOneLine) {
    const TemporaryFolder folder;
    for (const char* arguments : {"render builtin:triangle -o a.pfm --size 16000x16000 --spp 1",
                                  "render builtin:triangle -o a.pfm --size 16000x16000 --target-error 0.1",
                                  "probe builtin:ten-million --pixel 1,1", "bench builtin:ten-million"}) {
        const ProgramResult result =
            run(folder, "ulimit -v 600000; timeout 60 " + kQuotedProgram + " " + arguments);
        if (result.err.find("AddressSanitizer") != std::string::npos || result.exitCode == 127) GTEST_SKIP();
        EXPECT_EQ(result.exitCode, 2) << arguments << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr("error: out of memory")) << arguments;
        EXPECT_THAT(result.err, HasSubstr("; use ")) << arguments;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
}

}  // namespace
}  // namespace rayscope
