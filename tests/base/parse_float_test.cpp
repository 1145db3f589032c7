#include "base/parse_float.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rayscope::base {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(ParseFloat, ReadsDecimalNumbers) {
    EXPECT_EQ(parseFloat("1"), 1.0f);
    EXPECT_EQ(parseFloat("+1.5"), 1.5f);
    EXPECT_EQ(parseFloat("-.5"), -0.5f);
    EXPECT_EQ(parseFloat("5."), 5.0f);
    EXPECT_EQ(parseFloat("1e-3"), 1e-3f);
    EXPECT_EQ(parseFloat("1E+3"), 1e3f);
    EXPECT_EQ(parseFloat("007"), 7.0f);
    EXPECT_TRUE(std::signbit(*parseFloat("-0")));
}

TEST(ParseFloat, RoundsToTheNearestFloat) {
    EXPECT_EQ(parseFloat("16777217"), 16777216.0f);
    EXPECT_EQ(parseFloat("16777219"), 16777220.0f);
    EXPECT_EQ(parseFloat("0.1"), 0.1f);
}

TEST(ParseFloat, ReadsValuesBeyondTheRange) {
    EXPECT_EQ(parseFloat("1e39"), kInfinity);
    EXPECT_EQ(parseFloat("-1e39"), -kInfinity);
    EXPECT_EQ(parseFloat("1e999"), kInfinity);
    EXPECT_EQ(parseFloat("1e-999"), 0.0f);
    EXPECT_EQ(parseFloat("1e-46"), 0.0f);
    EXPECT_EQ(parseFloat("1e-40"), 1e-40f);
}

TEST(ParseFloat, ReadsNotANumberAndInfinity) {
    for (const char* word : {"nan", "NaN", "-nan", "nan(ind)", "-nan(snan)", "1.#QNAN", "-1.#IND", "1.#IND00",
                             "1.#QNAN0", "-1.#SNAN00"})
        EXPECT_TRUE(parseFloat(word) && std::isnan(*parseFloat(word))) << word;
    for (const char* word : {"inf", "Inf", "infinity", "1.#INF", "1.#INF00", "+inf"})
        EXPECT_EQ(parseFloat(word), kInfinity) << word;
    EXPECT_EQ(parseFloat("-1.#INF00"), -kInfinity);
}

TEST(ParseFloat, RejectsOtherWords) {
    for (const char* word : {"",        "-",   "+",    ".",  "e5", "1e", "1e+", "--1",    "+-1", "1.5.5",
                             "1.5-2.5", "1,5", "0x10", "1f", " 1", "1 ", "1.#", "1.#FOO", "one", "#"})
        EXPECT_FALSE(parseFloat(word)) << word;
}

}  // namespace
}  // namespace rayscope::base
