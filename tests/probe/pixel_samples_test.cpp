#include "probe/pixel_samples.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

TEST(PixelSamples, EqualTheProbe) {
    Diagnostics notes;
    const auto world = test::compileScene(loadScene("builtin:cornell-area", notes), {}, 16, 16);
    const probe::PixelSamples samples = probe::replayPixel(*world, 5, 8, 9, 16);
    ASSERT_EQ(samples.values.size(), 16u);
    for (int i = 0; i < 16; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const RayTree tree = probeSample(*world, 5, {8, 9, i});
        EXPECT_EQ(samples.values[k], tree.radiance);
        EXPECT_GE(samples.rays[k], tree.nodes.size());
        EXPECT_GE(samples.positions[k].x, 0.0);
        EXPECT_LT(samples.positions[k].y, 1.0);
        // The camera ray passes through that position.
        const glm::dvec3 direction(tree.nodes[0].ray.direction);
        const glm::dvec2 position =
            world->camera.project(glm::dvec3(tree.nodes[0].ray.origin) + direction) - glm::dvec2(8, 9);
        EXPECT_NEAR(position.x, samples.positions[k].x, 1e-4);
        EXPECT_NEAR(position.y, samples.positions[k].y, 1e-4);
    }
}

TEST(SampleStatistics, KnownNumbers) {
    const probe::SampleStatistics s = probe::statisticsOf({RgbSum(1.0), RgbSum(2.0), RgbSum(6.0)});
    EXPECT_NEAR(s.mean, 3.0, 1e-12);
    EXPECT_NEAR(s.deviation, std::sqrt(7.0), 1e-12);
    EXPECT_NEAR(s.errorOfMean(), std::sqrt(7.0 / 3.0), 1e-12);
    ASSERT_EQ(s.runningMean.size(), 3u);
    EXPECT_NEAR(s.runningMean[1], 1.5, 1e-12);
}

TEST(SampleStatistics, FindsTheOutlier) {
    std::vector<RgbSum> values;
    for (int i = 0; i < 20; ++i) values.emplace_back(1.0 + 0.01 * (i % 5));
    EXPECT_TRUE(probe::statisticsOf(values).outliers.empty());
    values[7] = RgbSum(50.0);
    EXPECT_EQ(probe::statisticsOf(values).outliers, std::vector<std::size_t>{7});
}

TEST(SampleStatistics, EmptySingleAndEqualSamples) {
    EXPECT_EQ(probe::statisticsOf({}).errorOfMean(), 0.0);
    EXPECT_EQ(probe::statisticsOf({RgbSum(4.0)}).deviation, 0.0);
    const probe::SampleStatistics equal = probe::statisticsOf(std::vector<RgbSum>(64, RgbSum(0.1)));
    EXPECT_EQ(equal.deviation, 0.0);
    EXPECT_TRUE(equal.outliers.empty());
}

}  // namespace
}  // namespace rayscope
