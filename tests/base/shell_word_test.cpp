#include "base/shell_word.h"

#include <gtest/gtest.h>

namespace rayscope {
namespace {

TEST(ShellWord, QuotesWhatTheShellWouldTakeApart) {
    EXPECT_EQ(base::shellWord("scenes/a-b_c.toml"), "scenes/a-b_c.toml");
    EXPECT_EQ(base::shellWord("max_depth=3"), "max_depth=3");
    EXPECT_EQ(base::shellWord(""), "''");
    EXPECT_EQ(base::shellWord("my scene.toml"), "'my scene.toml'");
    EXPECT_EQ(base::shellWord("$(it's)"), "'$(it'\\''s)'");
}

}  // namespace
}  // namespace rayscope
