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

}  // namespace
}  // namespace rayscope
