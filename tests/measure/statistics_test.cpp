// Quantiles against printed tables, intervals against their confidence level.
#include "measure/statistics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rayscope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Abramowitz and Stegun, table 26.10, and exact values for 1 and 2 degrees of freedom.
TEST(Statistics, StudentQuantilesMatchTables) {
    EXPECT_NEAR(measure::studentQuantile(0.975, 1), std::tan(0.475 * std::acos(-1.0)), 1e-9);
    EXPECT_NEAR(measure::studentQuantile(0.95, 2), 0.9 * std::sqrt(2.0 / (1.0 - 0.81)), 1e-9);
    EXPECT_NEAR(measure::studentQuantile(0.975, 7), 2.364624, 1e-6);
    EXPECT_NEAR(measure::studentQuantile(0.995, 30), 2.749996, 1e-6);
    EXPECT_NEAR(measure::studentQuantile(0.975, kInfinity), 1.959964, 1e-6);
    EXPECT_NEAR(measure::studentQuantile(0.025, 7), -2.364624, 1e-6);
    EXPECT_NEAR(measure::studentQuantile(0.5, 3), 0.0, 1e-9);
}

TEST(Statistics, IntervalsOfSmallSamples) {
    const std::vector<double> values{1.0, 2.0, 3.0};
    const Interval mean = measure::meanInterval(values);
    EXPECT_DOUBLE_EQ(mean.value, 2.0);
    EXPECT_NEAR(mean.upper, 2.0 + 4.302653 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(measure::predictionInterval(values).upper, 2.0 + 4.302653 * std::sqrt(4.0 / 3.0), 1e-6);
    EXPECT_EQ(measure::meanInterval(std::vector<double>{5.0}).upper, kInfinity);
    EXPECT_EQ(measure::medianInterval(std::vector<double>{5.0}).value, 5.0);
    EXPECT_EQ(measure::medianInterval(std::vector<double>{5.0}).upper, kInfinity);
}

TEST(Statistics, MedianIntervalIsBetweenOrderStatistics) {
    // Of 10 values, the 2nd and the 9th cover the median with 97.9 %, the 3rd and the 8th with only 89.1 %.
    const std::vector<double> ten{10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
    const Interval median = measure::medianInterval(ten);
    EXPECT_DOUBLE_EQ(median.value, 5.5);
    EXPECT_DOUBLE_EQ(median.lower, 2.0);
    EXPECT_DOUBLE_EQ(median.upper, 9.0);
    const Interval six = measure::medianInterval(std::vector<double>{1, 2, 3, 4, 5, 6});
    EXPECT_DOUBLE_EQ(six.lower, 1.0);
    EXPECT_DOUBLE_EQ(six.upper, 6.0);
}

/// The fraction of 4000 intervals, each of `count` random values, that contain `expected`.
template <class Draw, class Make>
double coverage(int count, double expected, Draw draw, Make make) {
    std::mt19937_64 random(7);
    int covered = 0;
    constexpr int kTimes = 4000;
    for (int time = 0; time < kTimes; ++time) {
        std::vector<double> values;
        for (int i = 0; i < count; ++i) values.push_back(draw(random));
        covered += make(values).contains(expected);
    }
    return static_cast<double>(covered) / kTimes;
}

// The standard error of a coverage of 95 % over 4000 times is 0.34 %.
TEST(Statistics, IntervalsHaveTheConfidenceLevel) {
    std::normal_distribution<double> normal(3.0, 2.0);
    std::lognormal_distribution<double> skewed(0.0, 0.5);
    const auto mean = [](const auto& v) { return measure::meanInterval(v); };
    const auto median = [](const auto& v) { return measure::medianInterval(v); };
    for (const int count : {2, 5, 20}) EXPECT_NEAR(coverage(count, 3.0, normal, mean), 0.95, 0.015) << count;
    for (const int count : {3, 6, 15, 40}) {
        const double covered = coverage(count, 1.0, skewed, median);
        EXPECT_GT(covered, 0.935) << count;
        EXPECT_LT(covered, 0.995) << count;
    }
}

TEST(Statistics, PredictionIntervalsContainTheNextValue) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(10.0, 1.0);
    int inside = 0;
    for (int time = 0; time < 4000; ++time) {
        std::vector<double> values;
        for (int i = 0; i < 6; ++i) values.push_back(normal(random));
        inside += measure::predictionInterval(values).contains(normal(random));
    }
    EXPECT_NEAR(inside / 4000.0, 0.95, 0.015);
}

TEST(Statistics, PairedRatiosCancelChangesInMachineLoad) {
    std::mt19937_64 random(3);
    std::lognormal_distribution<double> machine(0.0, 0.5), own(0.0, 0.01);
    std::vector<double> a, b;
    for (int i = 0; i < 20; ++i) {
        const double slow = machine(random);
        a.push_back(1.25 * slow * own(random));
        b.push_back(slow * own(random));
    }
    const Interval ratio = measure::ratioInterval(a, b);
    EXPECT_TRUE(ratio.contains(1.25));
    EXPECT_LT(ratio.upper / ratio.lower, 1.03);
}

TEST(Statistics, RootsAndSlopes) {
    const Interval root = measure::rootOf({4.0, -1.0, 9.0});
    EXPECT_DOUBLE_EQ(root.value, 2.0);
    EXPECT_DOUBLE_EQ(root.lower, 0.0);
    EXPECT_DOUBLE_EQ(root.upper, 3.0);
    EXPECT_NEAR(measure::slopeOf(std::vector<double>{0, 1, 2}, std::vector<double>{5, 4.5, 4}), -0.5, 1e-12);
}

}  // namespace
}  // namespace rayscope
