#include "sampling/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sampling/sample_stream.h"

namespace rayscope {
namespace {

TEST(NormalDeviate, InvertsTheCumulativeDistribution) {
    for (const float u : {0.0f, 1e-6f, 0.001f, 0.075f, 0.2f, 0.5f, 0.7f, 0.93f, 0.999f, 1.0f - 0x1p-24f}) {
        const double p = static_cast<double>(u) + 0x1p-25;
        const double x = sampling::normalDeviate(u);
        const double cumulative = 0.5 * std::erfc(-x / std::numbers::sqrt2);
        EXPECT_NEAR(cumulative, p, 1e-14 * p + 1e-16) << u;
        EXPECT_TRUE(std::isfinite(x));
    }
}

TEST(NormalDeviate, HasTheMomentsOfTheNormalDistribution) {
    double sum = 0.0, squares = 0.0;
    constexpr int kCount = 1 << 16;
    for (int i = 0; i < kCount; ++i) {
        const double x = sampling::normalDeviate(static_cast<float>(i) / kCount);
        sum += x;
        squares += x * x;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 1e-3);
    EXPECT_NEAR(squares / kCount, 1.0, 2e-3);
}

/// Second moments of uniform shapes: disk r²/4 per axis, square side²/12, hexagon 5 R²/24.
TEST(SampleAperture, HasTheSecondMomentsOfItsShape) {
    const double expected[] = {1.0 / 4.0, 4.0 / 12.0, 5.0 / 24.0};
    for (const LensShape shape : {LensShape::Disk, LensShape::Square, LensShape::Hexagon}) {
        double xx = 0.0, yy = 0.0, xy = 0.0, x = 0.0, y = 0.0;
        constexpr int kCount = 1 << 16;
        for (int i = 0; i < kCount; ++i) {
            const glm::vec2 u =
                sampling::SampleStream(SamplePattern::Sobol, 1, 0, 0, i, kCount).get2D(sampling::Dim::Pixel);
            const glm::dvec2 p = sampling::sampleAperture(shape, u);
            ASSERT_LE(glm::length(p), shape == LensShape::Square ? 1.4142136 : 1.0 + 1e-12);
            x += p.x, y += p.y, xx += p.x * p.x, yy += p.y * p.y, xy += p.x * p.y;
        }
        const double moment = expected[static_cast<int>(shape)];
        EXPECT_NEAR(x / kCount, 0.0, 1e-3);
        EXPECT_NEAR(y / kCount, 0.0, 1e-3);
        EXPECT_NEAR(xx / kCount, moment, 1e-3) << static_cast<int>(shape);
        EXPECT_NEAR(yy / kCount, moment, 1e-3);
        EXPECT_NEAR(xy / kCount, 0.0, 1e-3);
    }
}

}  // namespace
}  // namespace rayscope
