#include "viewer/panels/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rayscope::viewer {
namespace {

TEST(PlotTicks, areRoundNumbersWithinTheAxis) {
    EXPECT_EQ(plotTicks({0.0, 10.0}, 6), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(plotTicks({-0.5, 3.5}, 4), (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(plotTicks({0.5, 2000.0, true}, 6), (std::vector<double>{1, 10, 100, 1000}));
    EXPECT_EQ(plotTicks({1.0, 10.0, true}, 6), (std::vector<double>{1, 2, 5, 10}));
}

TEST(PlotTicks, areAtMostAsManyAsWantedForAnyAxis) {
    for (double low = 1e-12; low < 1e12; low *= 7.3)
        for (double factor = 1.0001; factor < 1e9; factor *= 3.1)
            for (const bool logarithmic : {false, true}) {
                const PlotAxis axis{low, low * factor, logarithmic};
                const std::vector<double> ticks = plotTicks(axis, 5);
                EXPECT_LE(ticks.size(), 5u) << low << " " << factor;
                EXPECT_GE(ticks.size(), 1u) << low << " " << factor;
                EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
                const double slack = 1e-6 * (axis.high - axis.low);
                EXPECT_GE(ticks.front(), axis.low - slack);
                EXPECT_LE(ticks.back(), axis.high + slack);
            }
}

TEST(PlotTicks, ofAnEmptyAxisAreItsValue) {
    EXPECT_EQ(plotTicks({3.0, 3.0}, 4), std::vector<double>{3.0});
    EXPECT_EQ(plotTicks({3.0, INFINITY}, 4), std::vector<double>{3.0});
}

}  // namespace
}  // namespace rayscope::viewer
