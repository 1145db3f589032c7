#include "base/duration_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rayscope::base {
namespace {

TEST(DurationText, HasOneFormatWithUnits) {
    EXPECT_EQ(durationText(0.0), "0.00 s");
    EXPECT_EQ(durationText(-1.0), "0.00 s");
    EXPECT_EQ(durationText(std::nan("")), "0.00 s");
    EXPECT_EQ(durationText(0.418), "0.42 s");
    EXPECT_EQ(durationText(9.99), "9.99 s");
    EXPECT_EQ(durationText(9.999), "10 s");
    EXPECT_EQ(durationText(59.4), "59 s");
    EXPECT_EQ(durationText(59.6), "1 min 00 s");
    EXPECT_EQ(durationText(332.0), "5 min 32 s");
    EXPECT_EQ(durationText(3599.6), "1 h 00 min");
    EXPECT_EQ(durationText(2.0 * 3600.0 + 5.0 * 60.0), "2 h 05 min");
    EXPECT_EQ(durationText(1076.0 * 3600.0 + 42.0 * 60.0 + 38.0), "44 d 20 h");
    EXPECT_EQ(durationText(std::numeric_limits<double>::infinity()), durationText(1e15));
}

}  // namespace
}  // namespace rayscope::base
