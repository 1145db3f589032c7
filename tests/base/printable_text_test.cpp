#include "base/printable_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/json_text.h"

namespace rayscope {
namespace {

TEST(PrintableText, EscapesWhatATerminalWouldActOn) {
    const std::pair<std::string, const char*> cases[] = {
        {"plain text", "plain text"},
        {"Küche 厨房 🍳", "Küche 厨房 🍳"},
        {"C:\\folder", "C:\\folder"},
        {"\033[31m", "\\x1B[31m"},
        {"\a\b\f\v", "\\x07\\x08\\x0C\\x0B"},
        {"a\nb\rc\td", "a\\nb\\rc\\td"},
        {std::string("a\0b", 3), "a\\x00b"},
        {"\x7f", "\\x7F"},
        {"\u0085\u009b", "\\u{0085}\\u{009B}"},                 // next line, CSI
        {"\u202E\u2066\u200F", "\\u{202E}\\u{2066}\\u{200F}"},  // direction
        {"\u2028\uFEFF", "\\u{2028}\\u{FEFF}"},
        {"b\xe9ton", "b\\xE9ton"},                     // Latin-1
        {"\xc0\xaf", "\\xC0\\xAF"},                    // overlong slash
        {"\xed\xa0\x80", "\\xED\\xA0\\x80"},           // surrogate
        {"\xf4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},  // beyond U+10FFFF
        {"\xe2\x82", "\\xE2\\x82"},                    // cut
        {"\xff\xfe", "\\xFF\\xFE"},
        {"", ""},
    };
    for (const auto& [text, expected] : cases) {
        EXPECT_EQ(base::printable(text), expected);
        EXPECT_EQ(base::printable(base::printable(text)), expected);
    }
    EXPECT_EQ(base::printableLines("a\n\033\n"), "a\n\\x1B\n");
}

TEST(PrintableText, EveryByteBecomesPrintable) {
    for (int byte = 0; byte < 256; ++byte) {
        const std::string text = base::printable(std::string(1, static_cast<char>(byte)));
        for (const char c : text) EXPECT_TRUE(c >= ' ' && c <= '~') << byte;
        EXPECT_FALSE(text.empty());
    }
}

TEST(PrintableText, LongTextsLoseTheirMiddle) {
    EXPECT_EQ(base::shortened("short", 5), "short");
    for (const std::size_t most : {8u, 20u, 60u, 500u}) {
        const std::string cut = base::shortened("begin" + std::string(1000000, 'x') + "end", most);
        EXPECT_LE(cut.size(), most);
        EXPECT_TRUE(cut.starts_with("b"));
        EXPECT_NE(cut.find(" … "), std::string::npos);
    }
    // Not within a character.
    std::string kitchen;
    for (int i = 0; i < 100; ++i) kitchen += "厨";
    for (std::size_t most = 8; most < 100; ++most)
        EXPECT_EQ(base::printable(base::shortened(kitchen, most)), base::shortened(kitchen, most)) << most;
    EXPECT_LE(base::quoted(std::string(1000000, '\0')).size(), 62u);
    EXPECT_EQ(base::quoted("a\nb"), "'a\\nb'");
}

TEST(PrintableText, InvalidBytesAreReplacedInMarkup) {
    EXPECT_EQ(base::validUtf8("b\xe9ton\n\033"), "b\uFFFDton\n\uFFFD");
}

TEST(JsonText, IsValidForAnyBytes) {
    for (int byte = 0; byte < 256; ++byte) {
        const std::string name = "a" + std::string(1, static_cast<char>(byte)) + "b";
        const std::string text = base::jsonText({{name, name}});
        EXPECT_EQ(base::printableLines(text), text) << byte;
        const nlohmann::json read = nlohmann::json::parse(text);
        const std::string expected = byte < 128 ? name : "a\uFFFDb";
        EXPECT_EQ(read.begin().key(), expected) << byte;
        EXPECT_EQ(read.begin().value(), expected) << byte;
    }
    EXPECT_EQ(base::jsonText({{"a", "\u009b\u202e"}}, -1), "{\"a\":\"\\u009b\\u202e\"}\n");
    EXPECT_EQ(base::jsonText({{"a", std::numeric_limits<double>::quiet_NaN()},
                              {"b", std::numeric_limits<double>::infinity()}},
                             -1),
              "{\"a\":null,\"b\":null}\n");
}

}  // namespace
}  // namespace rayscope
