#include "measure/trade/pareto.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rayscope {
namespace {

TradePoint point(const std::string& name, double seconds, double error, double spread = 0.05,
                 TradeRole role = TradeRole::Parameter) {
    TradePoint p;
    p.name = name;
    p.role = role;
    p.runs = 8;
    p.seconds = {seconds, seconds * (1 - spread), seconds * (1 + spread)};
    p.error = {error, error * (1 - spread), error * (1 + spread)};
    p.timeRatio = {2.0, 1.9, 2.1};
    p.efficiency = {1 / (error * error * seconds), 0, 0};
    return p;
}

TEST(Pareto, FindsTheFrontAndADominatedPoint) {
    std::vector<TradePoint> points{point("base", 1.0, 0.10, 0.05, TradeRole::Base), point("finer", 4.0, 0.05),
                                   point("planted", 4.5, 0.12), point("coarse", 0.25, 0.20)};
    EXPECT_EQ(measure::markParetoFront(points), (std::vector<std::size_t>{3, 0, 1}));
    EXPECT_FALSE(points[2].onParetoFront);
    EXPECT_NE(points[2].dominatedBy, "");
    for (const std::size_t i : {0u, 1u, 3u}) EXPECT_EQ(points[i].dominatedBy, "");
}

TEST(Pareto, InsignificantDifferencesDoNotDominate) {
    std::vector<TradePoint> points{point("base", 1.0, 0.10, 0.05, TradeRole::Base),
                                   point("worse", 1.02, 0.101)};
    measure::markParetoFront(points);
    EXPECT_FALSE(points[1].onParetoFront);
    EXPECT_EQ(points[1].dominatedBy, "");
}

TEST(Pareto, IdenticalPicturesAreComparedByTime) {
    std::vector<TradePoint> points{point("base", 1.0, 0.10, 0.05, TradeRole::Base),
                                   point("slow tree", 2.0, 0.10), point("like base", 1.01, 0.10)};
    points[1].samePicture = points[2].samePicture = true;
    points[2].timeRatio = {1.01, 0.95, 1.06};
    EXPECT_EQ(measure::markParetoFront(points), (std::vector<std::size_t>{0}));
    EXPECT_EQ(points[1].dominatedBy, "base");
    EXPECT_EQ(points[2].dominatedBy, "");
}

TEST(Pareto, ExcessTimeIsMeasuredAtTheSameError) {
    std::vector<TradePoint> points{point("base", 1.0, 0.16, 0.05, TradeRole::Base),
                                   point("finer", 4.0, 0.04)};
    const std::vector<std::size_t> front = measure::markParetoFront(points);
    // Halfway between both in the logarithm of the error the front needs 2 s.
    EXPECT_NEAR(measure::excessOverParetoFront(points, front, point("between", 3.0, 0.08)), 0.5, 1e-9);
    EXPECT_EQ(measure::excessOverParetoFront(points, front, points[1]), 0.0);
    EXPECT_EQ(measure::excessOverParetoFront(points, front, point("beyond", 9.0, 0.01)), 0.0);
    EXPECT_NEAR(measure::excessOverParetoFront(points, front, point("coarse", 1.5, 0.3)), 0.5, 1e-9);
}

TEST(Pareto, DifferencesWithinTimingNoiseDoNotDominate) {
    std::vector<TradePoint> points{point("base", 1.0, 0.10, 0.05, TradeRole::Base),
                                   point("slower", 2.0, 0.12)};
    measure::markParetoFront(points, 1.5);
    EXPECT_EQ(points[1].dominatedBy, "");
    measure::markParetoFront(points, 0.5);
    EXPECT_EQ(points[1].dominatedBy, "base");
}

TEST(Pareto, EffectsControlsAndSingleRunsAreNotOnTheFront) {
    std::vector<TradePoint> points{point("base", 1.0, 0.10, 0.05, TradeRole::Base),
                                   point("control", 0.5, 0.01, 0.05, TradeRole::Control),
                                   point("effect off", 0.5, 0.01, 0.05, TradeRole::Effect),
                                   point("once", 0.5, 0.01)};
    points[3].runs = 1;
    EXPECT_EQ(measure::markParetoFront(points), (std::vector<std::size_t>{0}));
}

TEST(Pareto, MeasuredPointIgnoresSettingsWithoutEffect) {
    TradeResult result;
    result.points = {point("base", 1.0, 0.10, 0.05, TradeRole::Base), point("finer", 4.0, 0.05),
                     point("never", 4.0, 0.05)};
    result.points[1].settings.spp = 64;
    result.points[2].settings.spp = 128;
    result.points[2].runs = 0;
    result.inactiveSettings = {"glossy_samples"};
    Settings settings;
    EXPECT_EQ(measuredPoint(result, settings), 0u);
    settings.spp = 64;
    settings.glossySamples = 3;
    settings.exposure = 2.0f;
    EXPECT_EQ(measuredPoint(result, settings), 1u);
    settings.maxDepth = 1;
    EXPECT_EQ(measuredPoint(result, settings), std::nullopt);
    settings = {};
    settings.spp = 128;
    EXPECT_EQ(measuredPoint(result, settings), std::nullopt) << "it was not run";
}

TEST(Pareto, AdviceFitsIntoItsBudget) {
    std::vector<TradePoint> points;
    for (int i = 0; i < 12; ++i)
        points.push_back(point(std::to_string(i), 0.1 * std::pow(1.7, i), std::pow(0.7, i), 0.1,
                               i == 0 ? TradeRole::Base : TradeRole::Parameter));
    const std::vector<std::size_t> front = measure::markParetoFront(points);
    const std::vector<TradeAdvice> advice = measure::adviceFrom(points, front);
    ASSERT_GE(advice.size(), 4u);
    EXPECT_EQ(advice.front().point, front.front());
    EXPECT_EQ(advice.back().point, front.back());
    for (const TradeAdvice& a : advice) {
        EXPECT_LE(points[a.point].seconds.upper, a.budgetSeconds * (1 + 1e-9));
        for (const std::size_t other : front)
            EXPECT_TRUE(points[other].seconds.upper > a.budgetSeconds ||
                        points[a.point].error.value <= points[other].error.value);
    }
    EXPECT_TRUE(measure::adviceFrom({}, {}).empty());
}

TEST(ExcessText, StatesWhetherTheExcessIsSignificant) {
    TradeResult result;
    result.points.resize(1);
    EXPECT_EQ(excessText(result, {"preview", 0, 0.0}), "0 %");
    EXPECT_EQ(excessText(result, {"preview", 0, 0.12}), "12 %, not significant");
    result.points[0].dominatedBy = "base";
    EXPECT_EQ(excessText(result, {"preview", 0, 0.12}), "12 %");
}

}  // namespace
}  // namespace rayscope
