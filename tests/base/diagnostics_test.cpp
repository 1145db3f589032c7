#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

namespace rayscope {
namespace {

TEST(Diagnostics, TextOmitsUnknownPartsOfThePosition) {
    EXPECT_EQ(toString({Severity::Error, "bad key", {"a.toml", 3, 7}}), "a.toml:3:7: error: bad key");
    EXPECT_EQ(toString({Severity::Warning, "bad key", {"a.toml", 3, 0}}), "a.toml:3: warning: bad key");
    EXPECT_EQ(toString({Severity::Note, "bad key", {"a.toml", 0, 0}}), "a.toml: note: bad key");
    EXPECT_EQ(toString({Severity::Error, "bad key", {}}), "error: bad key");
}

TEST(Diagnostics, ColumnWithoutLineIsOmitted) {
    EXPECT_EQ(toString({Severity::Error, "bad key", {"a.toml", 0, 7}}), "a.toml: error: bad key");
}

TEST(Diagnostics, InputErrorHasTheLineAndItsParts) {
    const InputError error("bad key", {"a.toml", 3, 7});
    EXPECT_STREQ(error.what(), "a.toml:3:7: error: bad key");
    EXPECT_EQ(error.diagnostic().message, "bad key");
    EXPECT_EQ(error.diagnostic().position.line, 3);
}

TEST(Diagnostics, ForeignTextStaysOnOneShortLine) {
    const std::string forged =
        toString({Severity::Error, "bad name 'x\nfake.toml:1:1: error: y'", {"a\nb", 1, 1}});
    EXPECT_EQ(forged, "a\\nb:1:1: error: bad name 'x\\nfake.toml:1:1: error: y'");
    for (const std::string& filling :
         {std::string(20000000, 'm'), std::string(1000, '\0'), std::string(2000, '\xff')}) {
        const std::string line = toString({Severity::Error,
                                           "unknown '" + filling + "' (did you mean 'n'?)",
                                           {std::string(5000, 'p'), 1, 1}});
        EXPECT_LE(line.size(), 500u);
        EXPECT_TRUE(line.ends_with("(did you mean 'n'?)")) << line;
        EXPECT_EQ(line.find('\0'), std::string::npos);
    }
}

}  // namespace
}  // namespace rayscope
