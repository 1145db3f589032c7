#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

namespace rayscope {
namespace {

TEST(Diagnostics, TextHasOnlyTheKnownPartsOfThePosition) {
    EXPECT_EQ(toString({Severity::Error, "odd", {"a.toml", 3, 7}}), "a.toml:3:7: error: odd");
    EXPECT_EQ(toString({Severity::Warning, "odd", {"a.toml", 3, 0}}), "a.toml:3: warning: odd");
    EXPECT_EQ(toString({Severity::Note, "odd", {"a.toml", 0, 0}}), "a.toml: note: odd");
    EXPECT_EQ(toString({Severity::Error, "odd", {}}), "error: odd");
}

TEST(Diagnostics, AColumnWithoutALineIsNotShown) {
    EXPECT_EQ(toString({Severity::Error, "odd", {"a.toml", 0, 7}}), "a.toml: error: odd");
}

TEST(Diagnostics, InputErrorSaysTheWholeLineAndKeepsTheParts) {
    const InputError error("odd", {"a.toml", 3, 7});
    EXPECT_STREQ(error.what(), "a.toml:3:7: error: odd");
    EXPECT_EQ(error.diagnostic().message, "odd");
    EXPECT_EQ(error.diagnostic().position.line, 3);
}

}  // namespace
}  // namespace rayscope
