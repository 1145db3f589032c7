#include "measure/statistics/svg_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace rayscope {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SvgChart, AxesAreLogarithmic) {
    measure::LogChart chart(800, 400, {1.0, 100.0}, {1.0, 100.0}, "x", "y");
    chart.line({{1.0, 1.0}, {10.0, 10.0}, {100.0, 100.0}}, "front");
    const std::string svg = chart.svg();
    const std::size_t at = svg.find("points='") + 8;
    double x[3], y[3];
    ASSERT_EQ(
        std::sscanf(svg.c_str() + at, "%lf,%lf %lf,%lf %lf,%lf", &x[0], &y[0], &x[1], &y[1], &x[2], &y[2]),
        6);
    EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.15);
    EXPECT_NEAR(y[0] - y[1], y[1] - y[2], 0.15);
    EXPECT_GT(x[1], x[0]);
    EXPECT_LT(y[1], y[0]) << "larger values are higher";
}

TEST(SvgChart, SkipsNonPositiveAndNonFiniteValues) {
    measure::LogChart chart(800, 400, measure::rangeOf({0.0, NAN, INFINITY}), measure::rangeOf({1e-9, 1e9}),
                            "x", "y");
    chart.mark({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, "a", "no");
    chart.mark({2.0, -INFINITY, INFINITY}, {1.0, 0.0, INFINITY}, "a", "<&>");
    const std::string svg = chart.svg();
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_THAT(svg, Not(HasSubstr("<title>no")));
    EXPECT_THAT(svg, HasSubstr("&lt;&amp;&gt;"));
}

}  // namespace
}  // namespace rayscope
