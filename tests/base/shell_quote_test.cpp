#include "base/shell_quote.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "base/printable_text.h"

namespace rayscope {
namespace {

TEST(ShellQuote, QuotesSpecialCharacters) {
    EXPECT_EQ(base::shellQuote("scenes/a-b_c.toml"), "scenes/a-b_c.toml");
    EXPECT_EQ(base::shellQuote("max_depth=3"), "max_depth=3");
    EXPECT_EQ(base::shellQuote(""), "''");
    EXPECT_EQ(base::shellQuote("my scene.toml"), "'my scene.toml'");
    EXPECT_EQ(base::shellQuote("$(it's)"), "'$(it'\\''s)'");
    EXPECT_EQ(base::shellQuote("=cat"), "'=cat'");
    EXPECT_EQ(base::shellQuote("K\u00fcche"), "'K\u00fcche'");
}

/// For the POSIX shell of popen().
std::string singleQuoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

TEST(ShellQuote, CommandsAreSafeAndReadBackByAShell) {
    EXPECT_EQ(base::shellQuotePath("-x.obj"), "./-x.obj");
    EXPECT_EQ(base::shellQuotePath("x.obj"), "x.obj");
    for (int byte = 1; byte < 256; ++byte) {
        const std::string word = "-" + std::string(1, static_cast<char>(byte)) + "'1\\";
        const std::string quoted = base::shellQuote(word);
        EXPECT_EQ(base::printable(quoted), quoted) << byte;
        const std::string command = "bash -c " + singleQuoted("printf %s " + quoted);
        std::FILE* const pipe = ::popen(command.c_str(), "r");
        ASSERT_NE(pipe, nullptr);
        std::string read(16, '\0');
        read.resize(std::fread(read.data(), 1, read.size(), pipe));
        ::pclose(pipe);
        EXPECT_EQ(read, word) << byte;
    }
}

}  // namespace
}  // namespace rayscope
