// Names and values of files in what the program prints: they must not act on a terminal, forge a line, or
// make JSON invalid.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/printable_text.h"
#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

/// A name with a line feed, an escape sequence, Latin-1 and a direction mark.
const std::string kHostile = "a\nf.toml:1:1: error: forged\033[2J\xe9\u202e";

/// For the shell.
std::string quoted(const std::string& text) { return "'" + text + "'"; }

void writeTriangle(const TemporaryFolder& folder, const std::string& name) {
    folder.write(name, "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl b\xe9ton\nf 1 2 3\n");
    folder.write("m.mtl", "newmtl b\xe9ton\nKd 1 0 0\n");
}

void expectPrintable(const std::string& text, const std::string& context) {
    EXPECT_EQ(base::printableLines(text), text) << context;
}

void expectJson(const std::string& text, const std::string& context) {
    EXPECT_TRUE(nlohmann::json::accept(text)) << context << "\n" << text.substr(0, 300);
    expectPrintable(text, context);
}

TEST(ForeignText, JsonIsValidForAnyNameInEveryCommand) {
    const TemporaryFolder folder;
    const std::string scene = "caf\xe9.obj";
    writeTriangle(folder, scene);
    const std::string name = quoted(scene);
    const std::pair<std::string, std::string> commands[] = {
        {"info --json " + name, ".out"},
        {"probe --size 9x9 --pixel 4,5 --traversal --explain --json j.json " + name, "j.json"},
        {"render --size 8x8 --spp 1 -o o.pfm --stats s.json " + name, "s.json"},
        {"bench --size 8 --rounds 5 -t 1 --json b.json " + name, "b.json"},
        {"lab --quick --rays 10 --json -q " + name, ".out"},
        {"lab --quick --rays 10 -o lab -q " + name, "lab/lab.json"},
        {"trade --size 8x8 --budget 0.2 --no-cache --json -q " + name, ".out"},
        {"trade --size 8x8 --budget 0.2 --no-cache -o trade -q " + name, "trade/trade.json"},
        {"settings --json", ".out"},
        {"info --list --json", ".out"},
        {"compare o.pfm o.pfm --json", ".out"},
    };
    for (const auto& [command, json] : commands) {
        const ProgramResult result = run(folder, "rayscope " + command);
        EXPECT_NE(result.exitCode, 1) << command << "\n" << result.err;
        EXPECT_NE(result.exitCode, 2) << command << "\n" << result.err;
        expectJson(test::readText(folder / json), command);
        expectPrintable(result.err, command);
    }
    const std::string page = test::readText(folder / "trade/trade.html");
    EXPECT_EQ(base::validUtf8(page), page);
    EXPECT_THAT(page, HasSubstr("rayscope render $&#39;caf\\351.obj&#39;"));
}

TEST(ForeignText, NoNameActsOnTheTerminal) {
    const TemporaryFolder folder;
    writeTriangle(folder, kHostile + ".obj");
    const std::string name = quoted(kHostile + ".obj");
    folder.write("title.toml",
                 "version = 1\ntitle = \"\\u001b[2Jt\\nf.toml:1:1: error: forged\"\n[[camera]]\nname = "
                 "\"c\\n\\u0007\"\nlook_from = [0, 0, 3]\nlook_at = [0, 0, 0]\n[[sphere]]\ncenter = [0, 0, "
                 "0]\nradius = 1\n");
    folder.write("key.toml", "version = 1\n\"\\u001b[2J\\nf.toml:1:1: error: forged\" = 1\n");
    folder.write(
        "name.toml",
        "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"x\\nf.toml:1:1: error: "
        "forged\"\n");
    folder.write(
        "setting.toml",
        "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n[settings]\ntone = \"\\u001b[2J\"\n");
    for (const std::string& arguments :
         {"info " + name, "probe --pixel 400,400 --explain " + name,
          "render -o o.pfm --size 8x8 --spp 1 " + name, "lab --quick --rays 10 -q " + name,
          "trade --size 8x8 --budget 0.2 --no-cache -q " + name,
          "cast --rays no.rays -o " + name + " " + name, "compare " + name + " " + name,
          std::string("info title.toml"), std::string("info key.toml"), std::string("info name.toml"),
          std::string("render setting.toml -o o.pfm"), "render builtin:triangle -o " + name,
          "render builtin:triangle -o o.pfm --set " + name,
          "render builtin:triangle -o o.pfm --camera " + name,
          "render builtin:triangle -o o.pfm --preset " + name, name, "--" + kHostile + "x",
          "render builtin:triangle -o o.pfm --aov " + name}) {
        const ProgramResult result = run(folder, "rayscope " + arguments);
        expectPrintable(result.out, arguments);
        expectPrintable(result.err, arguments);
        for (const std::string& text : {result.out, result.err}) {
            EXPECT_FALSE(text.starts_with("f.toml:1:1:")) << arguments << "\n" << text;
            EXPECT_THAT(text, Not(HasSubstr("\nf.toml:1:1:"))) << arguments;
        }
    }
}

TEST(ForeignText, LinesStayShort) {
    const TemporaryFolder folder;
    const std::string word(200000, 'm');
    folder.write("long.toml", "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n" + word + " = 1\n");
    folder.write("arguments", "--" + word + "\n");
    for (const std::string& command :
         {std::string("rayscope info long.toml"),
          "rayscope render builtin:triangle --size " + word.substr(0, 90000),
          "rayscope info " + word.substr(0, 90000),
          "rayscope render builtin:triangle -o a.png --set spp=" + word.substr(0, 90000)}) {
        const ProgramResult result = run(folder, command);
        EXPECT_GE(result.exitCode, 1);
        EXPECT_LE(result.err.find('\n'), 500u) << result.err.substr(0, 600);
    }
}

}  // namespace
}  // namespace rayscope
