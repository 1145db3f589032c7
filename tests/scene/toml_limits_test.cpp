// Scene files with keys, names and lists of any length.
#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class TomlLimits : public SceneFiles {};

TEST_F(TomlLimits, DeepKeysAreErrorsWithAPosition) {
    std::string deep;
    for (int i = 0; i < 60000; ++i) deep += "a.";
    for (const std::string& text :
         {"version = 1\n" + deep + "b = 1\n", "version = 1\n[" + deep + "b]\n",
          "version = 1\n[[" + deep + "b]]\n", "version = 1\nx = { " + deep + "b = 1 }\n",
          "version = 1\n" + deep + "b = { " + deep + "c = 2 }\n"})
        EXPECT_THAT(errorOf(write("scene.toml", text)),
                    ::testing::AllOf(StartsWith("scene.toml:2:"), HasSubstr("256 parts")));
    // Keys of 200 parts within each other add up.
    std::string part, nested = "version = 1\n";
    for (int i = 0; i < 200; ++i) part += "a.";
    for (int i = 0; i < 100; ++i) nested += part + "b = { ";
    EXPECT_THAT(errorOf(write("scene.toml", nested)), HasSubstr("256 parts"));
    // Dots elsewhere do not count.
    std::string harmless = "version = 1\ntitle = \"" + std::string(1000, '.') + "\" # " +
                           std::string(1000, '.') + "\n[material.\"" + std::string(1000, '.') +
                           "\"]\nkd = [0.5, 0.5, 0.5]\n";
    harmless +=
        "[[mesh]]\ngenerate = { shape = \"quad\" }\ntransform = { matrix = [1.0,0.0,0.0,0.0, "
        "0.0,1.0,0.0,0.0, 0.0,0.0,1.0,0.0, 0.0,0.0,0.0,1.0] }\n";
    EXPECT_EQ(errorOf(write("scene.toml", harmless)), "");
}

TEST_F(TomlLimits, OtherEncodingsAreNamed) {
    const std::string bom = "\xef\xbb\xbf";
    EXPECT_EQ(errorOf(write("a.toml", bom + "version = 1\r\n[material.a]\r\n")), "");
    EXPECT_THAT(errorOf(write("a.toml", std::string("\xff\xfe"
                                                    "v\0e\0",
                                                    6))),
                HasSubstr("UTF-16"));
    EXPECT_THAT(errorOf(write("a.toml", std::string("\xfe\xff"
                                                    "\0v\0e",
                                                    6))),
                HasSubstr("UTF-16"));
    EXPECT_THAT(errorOf(write("a.toml", std::string("\xff\xfe\0\0v\0\0\0", 8))), HasSubstr("UTF-32"));
    EXPECT_THAT(errorOf(write("a.toml", "\x1f\x8b\x08")), HasSubstr("gzip"));
    EXPECT_THAT(errorOf(write("a.toml", "version = 1\r[material.a]\r")), HasSubstr("CR alone"));
    EXPECT_THAT(errorOf(write("a.toml", "version = 1\ntitle = \"caf\xe9\"\n")),
                ::testing::AllOf(StartsWith("a.toml:2:"), HasSubstr("save the file as UTF-8")));
}

TEST_F(TomlLimits, LongNamesAndListsAreShort) {
    const std::string name(100000, 'm'), other(100000, 'n');
    const std::string error = errorOf(
        write("scene.toml",
              "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"x\"\n[material." +
                  other + "]\n"));
    EXPECT_LT(error.size(), 300u);
    std::string many = "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"x\"\n";
    for (int i = 0; i < 2000; ++i) many += "[material.m" + std::to_string(i) + "]\n";
    EXPECT_THAT(errorOf(write("scene.toml", many)), HasSubstr("or 1982 more"));
    std::string cameras = "version = 1\n";
    for (int i = 0; i < 20000; ++i) cameras += "[[camera]]\nlook_from = [0, 0, 3]\n";
    EXPECT_EQ(errorOf(write("scene.toml", cameras)), "");
}

}  // namespace
}  // namespace rayscope::test
