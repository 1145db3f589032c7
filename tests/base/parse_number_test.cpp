#include "base/parse_number.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace rayscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParseNumber, ReadsDecimalNumbers) {
    const std::pair<const char*, double> cases[] = {
        {"0", 0.0},
        {"-0", 0.0},
        {"+1", 1.0},
        {"1.", 1.0},
        {".5", 0.5},
        {"-2.5e-3", -2.5e-3},
        {"1E5", 1e5},
        {"007", 7.0},
        {"1e+2", 100.0},
        {"1e400", kInfinity},
        {"-1e400", -kInfinity},
        {"1e-400", 0.0},
        {"1e99999999999999999999", kInfinity},
        {"1e-99999999999999999999", 0.0},
        {"0e99999", 0.0},
        {"0.1e400", kInfinity},
    };
    for (const auto& [text, expected] : cases) {
        ASSERT_TRUE(base::parseReal<double>(text)) << text;
        EXPECT_EQ(*base::parseReal<double>(text), expected) << text;
    }
    EXPECT_EQ(base::parseReal<double>(std::string(400, '1')), kInfinity);
    EXPECT_EQ(base::parseReal<double>("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(base::parseReal<double>(std::string(1000, '1').append("e-10")), kInfinity);
    EXPECT_EQ(base::parseReal<float>("1e39"), std::numeric_limits<float>::infinity());
    EXPECT_EQ(base::parseReal<float>("3.4028235e38"), std::numeric_limits<float>::max());
    EXPECT_EQ(base::parseReal<float>("1e-46"), 0.0f);
    EXPECT_EQ(base::parseReal<float>("1e-45"), std::numeric_limits<float>::denorm_min());
}

TEST(ParseNumber, EverythingElseIsNoNumber) {
    for (const char* text :
         {"",     " ",   "1 ", " 1",  "nan",   "-nan",  "inf",   "-inf",     "infinity", "NaN",
          "0x10", "1,5", "1x", "--1", "+-1",   "-+1",   "++1",   "-",        "+",        ".",
          "-.",   "e5",  "1e", "1e+", "1.2.3", "1_000", "1'000", "\xd9\xa1", "½"}) {
        EXPECT_FALSE(base::parseReal<double>(text)) << text;
        EXPECT_FALSE(base::parseInteger<int>(text)) << text;
    }
    EXPECT_FALSE(base::parseReal<double>(std::string_view("1\0", 2)));
}

TEST(ParseNumber, IntegersStayInTheirRange) {
    EXPECT_EQ(base::parseInteger<int>("2147483647"), 2147483647);
    EXPECT_EQ(base::parseInteger<int>("-2147483648"), std::numeric_limits<int>::min());
    EXPECT_EQ(base::parseInteger<int>("+5"), 5);
    EXPECT_EQ(base::parseInteger<std::uint64_t>("18446744073709551615"),
              std::numeric_limits<std::uint64_t>::max());
    for (const char* text : {"2147483648", "-2147483649", "1.0", "1e3", "1.5"})
        EXPECT_FALSE(base::parseInteger<int>(text)) << text;
    for (const char* text : {"18446744073709551616", "-1", "+-1"})
        EXPECT_FALSE(base::parseInteger<std::uint64_t>(text)) << text;
}

}  // namespace
}  // namespace rayscope
