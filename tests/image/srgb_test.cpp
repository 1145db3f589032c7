#include "image/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "support/non_finite.h"

namespace rayscope {
namespace {

using test::kInfinity, test::kNaN;

/// The curve in double precision.
double exactEncoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

TEST(Srgb, EveryCodeSurvivesDecodingAndEncoding) {
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(image::encodeByte(image::decodeByte(static_cast<std::uint8_t>(code)), Encoding::Srgb),
                  code);
}

TEST(Srgb, CodesAreMonotonic) {
    int last = 0;
    for (int i = 0; i <= 100000; ++i) {
        const int code = image::encodeByte(static_cast<float>(i) / 100000.0f, Encoding::Srgb);
        ASSERT_GE(code, last) << i;
        last = code;
    }
    EXPECT_EQ(last, 255);
}

TEST(Srgb, CodesAreNearest) {
    for (int i = 0; i <= 20000; ++i) {
        const float linear = static_cast<float>(i) / 20000.0f;
        // Half a code, plus the rounding of the few float operations of the curve near 255.
        const double slack = 0.5 + 255.0 * 8.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
        ASSERT_LE(std::abs(image::encodeByte(linear, Encoding::Srgb) -
                           255.0 * exactEncoded(static_cast<double>(linear))),
                  slack)
            << i;
    }
}

TEST(Srgb, CodesAreThoseOfTheCurveAroundEveryStep) {
    const auto exact = [](float linear) {
        return static_cast<int>(255.0f * image::linearToSrgb(linear) + 0.5f);
    };
    for (int code = 1; code < 256; ++code) {
        // The largest value with a lower code, by bisection.
        float below = 0.0f, above = 1.0f;
        while (std::nextafter(below, 1.0f) < above) {
            const float middle = 0.5f * (below + above);
            (exact(middle) < code ? below : above) = middle;
        }
        EXPECT_EQ(image::encodeByte(below, Encoding::Srgb), code - 1);
        EXPECT_EQ(image::encodeByte(above, Encoding::Srgb), code);
    }
    for (std::uint32_t bits = 1; bits < std::bit_cast<std::uint32_t>(1.0f); bits += 4099) {
        const float linear = std::bit_cast<float>(bits);
        ASSERT_EQ(image::encodeByte(linear, Encoding::Srgb), exact(linear)) << linear;
    }
}

TEST(Srgb, KnownPointsOfTheCurve) {
    EXPECT_EQ(image::encodeByte(0.0f, Encoding::Srgb), 0);
    EXPECT_EQ(image::encodeByte(1.0f, Encoding::Srgb), 255);
    EXPECT_EQ(image::encodeByte(0.18f, Encoding::Srgb), 118);  // photographic grey: 255 · 0.4614
    EXPECT_EQ(image::encodeByte(0.5f, Encoding::Srgb), 188);   // 255 · 0.7354
    EXPECT_EQ(image::decodeByte(0), 0.0f);
    EXPECT_EQ(image::decodeByte(255), 1.0f);
}

TEST(Srgb, NoneTruncates) {
    EXPECT_EQ(image::encodeByte(0.5f, Encoding::None), 127);  // 127.5
    EXPECT_EQ(image::encodeByte(254.99f / 255.0f, Encoding::None), 254);
    EXPECT_EQ(image::encodeByte(1.0f, Encoding::None), 255);
}

TEST(Srgb, ValuesOutsideTheRangeAreClamped) {
    for (const Encoding encoding : {Encoding::Srgb, Encoding::None}) {
        EXPECT_EQ(image::encodeByte(-1.0f, encoding), 0);
        EXPECT_EQ(image::encodeByte(-kInfinity, encoding), 0);
        EXPECT_EQ(image::encodeByte(kNaN, encoding), 0);
        EXPECT_EQ(image::encodeByte(7.0f, encoding), 255);
        EXPECT_EQ(image::encodeByte(kInfinity, encoding), 255);
        EXPECT_EQ(image::encodeByte(std::nextafter(1.0f, 0.0f), encoding),
                  encoding == Encoding::Srgb ? 255 : 254);
    }
}

}  // namespace
}  // namespace rayscope
