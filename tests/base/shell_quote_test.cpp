#include "base/shell_quote.h"

#include <gtest/gtest.h>

namespace rayscope {
namespace {

TEST(ShellQuote, QuotesSpecialCharacters) {
    EXPECT_EQ(base::shellQuote("scenes/a-b_c.toml"), "scenes/a-b_c.toml");
    EXPECT_EQ(base::shellQuote("max_depth=3"), "max_depth=3");
    EXPECT_EQ(base::shellQuote(""), "''");
    EXPECT_EQ(base::shellQuote("my scene.toml"), "'my scene.toml'");
    EXPECT_EQ(base::shellQuote("$(it's)"), "'$(it'\\''s)'");
}

}  // namespace
}  // namespace rayscope
