// The trend of error estimates: slope, smoothing, and forecast of the target.
#include "measure/target/error_trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measure/target/half_films.h"

namespace rayscope {
namespace {

ErrorEstimate estimateOf(double error) { return {error, 1.3 * error, true}; }

TEST(ErrorTrend, SlopeStartsAtTheUsualOneAndConvergesToTheTrueOne) {
    measure::ErrorTrend trend(ErrorMetric::Rmse, SamplePattern::Independent),
        sobol(ErrorMetric::Rmse, SamplePattern::Sobol);
    EXPECT_FALSE(trend.hasEstimate());
    trend.add(4, estimateOf(1.0));
    sobol.add(4, estimateOf(1.0));
    EXPECT_DOUBLE_EQ(trend.slope(), 0.5);
    EXPECT_DOUBLE_EQ(sobol.slope(), 0.8);
    for (int samples = 5; samples <= 4096; samples = measure::roundUpSampleCount(samples + 1))
        trend.add(samples, estimateOf(4.0 / samples));
    EXPECT_GT(trend.slope(), 0.9);
    EXPECT_LE(trend.slope(), 1.0);
}

TEST(ErrorTrend, ForecastsTheTargetOfAPowerLaw) {
    measure::ErrorTrend trend(ErrorMetric::Rmse, SamplePattern::Sobol),
        squares(ErrorMetric::RelMse, SamplePattern::Sobol);
    for (int samples = 4; samples <= 64; samples *= 2) {
        const double error = std::pow(samples, -0.8);
        trend.add(samples, estimateOf(error));
        squares.add(samples, {error * error, 1.69 * error * error, true});
    }
    const double target = 1.3 * std::pow(200.0, -0.8);
    EXPECT_NEAR(trend.samplesFor(target), 200.0, 1e-9);
    EXPECT_NEAR(squares.samplesFor(target * target), 200.0, 1e-9);
    EXPECT_NEAR(trend.errorAt(128.0), std::pow(128.0, -0.8), 1e-12);
    EXPECT_NEAR(squares.errorAt(128.0), std::pow(128.0, -1.6), 1e-12);
    EXPECT_NEAR(trend.smoothed().upper, 1.3 * std::pow(64.0, -0.8), 1e-12);
}

TEST(ErrorTrend, SmoothedEstimateHasLessVarianceThanTheLatest) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0.0, 0.2);
    double single = 0.0, together = 0.0;
    for (int time = 0; time < 200; ++time) {
        measure::ErrorTrend trend(ErrorMetric::Rmse, SamplePattern::Sobol);
        for (int samples = 4; samples <= 128; samples = measure::roundUpSampleCount(samples + 1))
            trend.add(samples, estimateOf(std::pow(samples, -0.8) * std::exp(noise(random))));
        const double expected = std::pow(128.0, -0.8);
        single += std::pow(std::log(trend.latest().error / expected), 2.0);
        together += std::pow(std::log(trend.smoothed().error / expected), 2.0);
    }
    EXPECT_LT(together, 0.4 * single);
}

TEST(ErrorTrend, IgnoresEstimatesOfZero) {
    measure::ErrorTrend trend(ErrorMetric::Rmse, SamplePattern::Sobol);
    for (const int samples : {4, 5, 6, 7}) trend.add(samples, {});
    EXPECT_EQ(trend.smoothed().upper, 0.0);
    EXPECT_EQ(trend.samplesFor(0.01), 0.0);
    trend.add(8, {0.5, 1.0, false});
    EXPECT_DOUBLE_EQ(trend.smoothed().upper, 1.0);
    EXPECT_FALSE(trend.smoothed().reliable);
    EXPECT_TRUE(std::isfinite(trend.samplesFor(0.01)));
}

TEST(SampleCounts, DivideDoublingsIntoQuarters) {
    std::vector<int> steps;
    for (int step = measure::roundUpSampleCount(-1.0); step <= 64;
         step = measure::roundUpSampleCount(step + 1))
        steps.push_back(step);
    EXPECT_EQ(steps, (std::vector<int>{4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 56, 64}));
    EXPECT_EQ(measure::roundUpSampleCount(64.01), 80);
    EXPECT_GT(measure::roundUpSampleCount(1e300), 0);
}

}  // namespace
}  // namespace rayscope
