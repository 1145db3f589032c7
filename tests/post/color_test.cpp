// Exposure and the two encodings against known pairs.
#include <gtest/gtest.h>
#include <rayscope/display.h>

#include <cmath>
#include <limits>

#include "image/srgb.h"
#include "post/bloom.h"
#include "post/display_transform.h"

namespace rayscope {
namespace {

TEST(Encoding, SrgbMatchesKnownPairs) {
    // Linear value and 8-bit code, from the definition in IEC 61966-2-1.
    const std::pair<double, int> pairs[] = {{0.0, 0},         {0.0003035, 1},   {0.0031308, 10},
                                            {0.02028856, 39}, {0.1844, 119},    {0.2158605, 128},
                                            {0.5, 188},       {0.7379104, 223}, {1.0, 255}};
    for (const auto& [linear, code] : pairs)
        EXPECT_EQ(int{image::encodeByte(static_cast<float>(linear), Encoding::Srgb)}, code) << linear;
    for (int code = 0; code < 256; ++code) {
        const double s = code / 255.0, exact = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(static_cast<double>(image::decodeByte(static_cast<std::uint8_t>(code))), exact, 1e-6);
        EXPECT_EQ(int{image::encodeByte(image::decodeByte(static_cast<std::uint8_t>(code)), Encoding::Srgb)},
                  code);
    }
}

TEST(Encoding, ColoursOfTheDisplayAreThoseOfFiles) {
    for (int code = 0; code < 256; ++code) {
        const float shown = static_cast<float>(code) / 255.0f;
        const Rgb linear = fromDisplay(Rgb(shown, 0.0f, 1.0f));
        EXPECT_NEAR(static_cast<double>(linear.r),
                    static_cast<double>(image::decodeByte(static_cast<std::uint8_t>(code))), 1e-6);
        EXPECT_EQ(linear.g, 0.0f);
        EXPECT_EQ(linear.b, 1.0f);
        EXPECT_NEAR(static_cast<double>(toDisplay(linear).r), static_cast<double>(shown), 1e-6);
    }
}

TEST(Encoding, NoneClampsAndTruncates) {
    const std::pair<float, int> pairs[] = {{0.0f, 0},     {0.0039f, 0}, {0.00393f, 1}, {0.5f, 127},
                                           {0.999f, 254}, {1.0f, 255},  {7.0f, 255},   {-1.0f, 0}};
    for (const auto& [linear, code] : pairs)
        EXPECT_EQ(int{image::encodeByte(linear, Encoding::None)}, code) << linear;
}

TEST(Encoding, IsMonotonicAndHandlesNonFiniteValues) {
    for (const Encoding encoding : {Encoding::Srgb, Encoding::None}) {
        int before = 0;
        for (float x = 0.0f; x <= 1.0f; x += 1.0f / 4096.0f) {
            const int code = image::encodeByte(x, encoding);
            EXPECT_GE(code, before);
            before = code;
        }
        EXPECT_EQ(int{image::encodeByte(std::numeric_limits<float>::quiet_NaN(), encoding)}, 0);
        EXPECT_EQ(int{image::encodeByte(std::numeric_limits<float>::infinity(), encoding)}, 255);
    }
}

TEST(Exposure, IsInStops) {
    const RgbImage image(1, 1, Rgb(0.25f, 0.5f, 1.0f));
    Settings settings;
    for (const float stops : {-20.0f, -1.0f, 0.5f, 2.0f, 20.0f}) {
        settings.exposure = stops;
        const double factor = std::pow(2.0, static_cast<double>(stops));
        EXPECT_NEAR(static_cast<double>(post::applyDisplayTransform(image, settings, true).pixels[0].x) /
                        (0.25 * factor),
                    1.0, 1e-6);
    }
}

/// Bloom works on linear values, before exposure: the glow of a light of 8 is 8 times that of 1.
TEST(Exposure, IsAppliedAfterBloom) {
    RgbImage image(5, 5, Rgb(0.0f));
    image.at(2, 2) = Rgb(8.0f);
    Settings settings;
    settings.bloom = true;
    settings.exposure = -3.0f;
    const RgbImage exposed = post::applyDisplayTransform(image, settings, true),
                   bloomed = post::applyBloom(image, settings);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(exposed.pixels[i], bloomed.pixels[i] * 0.125f);
    EXPECT_GT(exposed.at(1, 2).x, 0.0f);
}

TEST(Bloom, IsFiniteAtTheLimitsOfItsSettings) {
    RgbImage image(9, 7, Rgb(0.2f));
    image.at(4, 3) = Rgb(50.0f);
    for (const BloomFilter filter : {BloomFilter::Box, BloomFilter::Gaussian})
        for (const float sigma : {0.0f, 0.5f, 10.0f, 100.0f})
            for (const float threshold : {0.0f, 1.0f, 1000.0f})
                for (const int size : {0, 50, 500})
                    for (const float scale : {0.0f, 0.5f, 5.0f, 100.0f}) {
                        Settings settings;
                        settings.bloom = true;
                        settings.bloomFilter = filter;
                        settings.bloomSigma = sigma;
                        settings.bloomThreshold = threshold;
                        settings.bloomSize = size;
                        settings.bloomScale = scale;
                        const RgbImage result = post::applyBloom(image, settings);
                        for (std::size_t i = 0; i < result.pixels.size(); ++i) {
                            ASSERT_TRUE(std::isfinite(result.pixels[i].x));
                            ASSERT_GE(result.pixels[i].x, image.pixels[i].x);
                        }
                    }
}

}  // namespace
}  // namespace rayscope
