#include "viewer/jobs/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "render/film.h"
#include "trace/compile.h"

namespace rayscope::viewer {
namespace {

RgbImage ramp(int width) {
    RgbImage image(width, 1);
    for (int x = 0; x < width; ++x) image.at(x, 0) = Rgb(static_cast<float>(x));
    return image;
}

TEST(HeatStatistics, OfARamp) {
    const HeatStatistics s = heatStatistics(ramp(1000));
    EXPECT_EQ(s.lowest, 0.0);
    EXPECT_EQ(s.highest, 999.0);
    EXPECT_NEAR(s.mean, 499.5, 1e-6);
    EXPECT_NEAR(s.upperPercentile, 989.0, 1.5);
    for (const std::size_t count : s.counts) EXPECT_NEAR(static_cast<double>(count), 1000.0 / 64.0, 2.0);
}

TEST(HeatStatistics, IgnoreNonFiniteValues) {
    RgbImage image = ramp(10);
    image.at(3, 0) = Rgb(std::numeric_limits<float>::quiet_NaN());
    image.at(4, 0) = Rgb(std::numeric_limits<float>::infinity());
    EXPECT_EQ(heatStatistics(image).highest, 9.0);
    EXPECT_EQ(heatStatistics(RgbImage(3, 0)).highest, 0.0);
    const HeatStatistics equal = heatStatistics(RgbImage(5, 5));
    EXPECT_EQ(equal.counts[0], 25u);
}

TEST(HeatColors, SpanTheRange) {
    RgbImage values = ramp(101);
    values.at(50, 0) = Rgb(std::numeric_limits<float>::quiet_NaN());
    const RgbImage image = applyColorMap(values, ColorMap::BlueGold, 20.0, 80.0);
    EXPECT_EQ(image.at(0, 0), mapColor(ColorMap::BlueGold, 0.0));
    EXPECT_EQ(image.at(20, 0), mapColor(ColorMap::BlueGold, 0.0));
    EXPECT_EQ(image.at(80, 0), mapColor(ColorMap::BlueGold, 1.0));
    EXPECT_EQ(image.at(100, 0), mapColor(ColorMap::BlueGold, 1.0));
    EXPECT_EQ(image.at(50, 0), Rgb(1.0f, 0.0f, 1.0f));
    EXPECT_LT(glm::distance(image.at(49, 0), mapColor(ColorMap::BlueGold, 29.0 / 60.0)), 2e-3f);
    // A range without extent has two colours.
    EXPECT_EQ(applyColorMap(ramp(3), ColorMap::Grey, 1.0, 1.0).at(2, 0), mapColor(ColorMap::Grey, 1.0));
}

TEST(HeatMap, ComputesTheSelectedQuantityInTheBackground) {
    Diagnostics notes;
    const auto scene = std::make_shared<const SceneDescription>(loadScene("builtin:cornell", notes));
    const auto world = trace::compile({scene, Settings{}, scene->cameras.front(), 24, 16});
    HeatMap heat;
    const auto finish = [&] {
        for (int i = 0; i < 2000; ++i) {
            heat.update(world, nullptr, 1);
            if (!heat.busy()) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    };
    finish();
    EXPECT_EQ(heat.image(), nullptr) << "not shown";
    heat.shown = true;
    finish();
    ASSERT_NE(heat.image(), nullptr);
    EXPECT_EQ(heat.image()->width, 24);
    EXPECT_GT(heat.statistics().highest, 5.0);
    const int version = heat.version();
    finish();
    EXPECT_EQ(heat.version(), version) << "nothing changed";
    heat.aov = Aov::Depth;
    finish();
    EXPECT_GT(heat.version(), version);
    EXPECT_LT(heat.statistics().highest, 10.0);
}

}  // namespace
}  // namespace rayscope::viewer
