#include "post/bloom.h"

#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

#include <cmath>
#include <limits>
#include <random>
#include <stop_token>

#include "post/display_transform.h"

namespace rayscope {
namespace {

RgbImage noise(int width, int height) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0.0f, 2.0f);
    RgbImage image(width, height);
    for (Rgb& pixel : image.pixels) pixel = {uniform(random), uniform(random), uniform(random)};
    return image;
}

TEST(BloomKernel, SumsToOneForEverySigma) {
    for (const double sigma : {0.0, 1e-6, 0.3, 0.5, 1.0, 10.0, 50.0, 1e6})
        for (const int radius : {0, 1, 2, 50}) {
            double sum = 0.0;
            for (const double weight : post::bloomKernel(BloomFilter::Gaussian, radius, sigma)) sum += weight;
            EXPECT_NEAR(sum, 1.0, 0x1p-52 * (2 * radius + 1)) << sigma << " " << radius;
        }
}

TEST(BloomKernel, HasTheLimitsOfSigma) {
    EXPECT_EQ(post::bloomKernel(BloomFilter::Gaussian, 2, 0.0), (std::vector<double>{0, 0, 1, 0, 0}));
    EXPECT_EQ(post::bloomKernel(BloomFilter::Gaussian, 2, 1e-6), (std::vector<double>{0, 0, 1, 0, 0}));
    for (const double weight : post::bloomKernel(BloomFilter::Gaussian, 2, 1e6))
        EXPECT_NEAR(weight, 0.2, 1e-9);
    EXPECT_EQ(post::bloomKernel(BloomFilter::Box, 0, 1.0), std::vector<double>{1.0});
}

TEST(BloomKernel, IntegratesTheGaussianOverEachPixel) {
    const std::vector<double> kernel = post::bloomKernel(BloomFilter::Gaussian, 6, 1.0);
    // An independent integral over the pixel, by Simpson's rule.
    const auto density = [](double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * 3.14159265358979); };
    for (int i = -6; i <= 6; ++i) {
        double sum = 0.0;
        constexpr int kSteps = 100;
        for (int k = 0; k <= kSteps; ++k)
            sum += density(i - 0.5 + k / 100.0) * (k == 0 || k == kSteps ? 1 : (k % 2 ? 4 : 2));
        EXPECT_NEAR(kernel[static_cast<std::size_t>(i + 6)], sum / 300.0, 1e-9);
    }
}

TEST(Bloom, ImpulseResponseIsTheOuterProductOfTheKernel) {
    RgbImage image(15, 15, Rgb(0.0f));
    image.at(7, 7) = Rgb(1.0f, 2.0f, 4.0f);
    const std::vector<double> kernel = post::bloomKernel(BloomFilter::Gaussian, 3, 1.3);
    const RgbImage filtered = post::bloomFiltered(image, kernel);
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 15; ++x) {
            const bool inside = std::abs(x - 7) <= 3 && std::abs(y - 7) <= 3;
            const double weight =
                inside ? kernel[static_cast<std::size_t>(x - 4)] * kernel[static_cast<std::size_t>(y - 4)]
                       : 0.0;
            EXPECT_NEAR(filtered.at(x, y).z, 4.0 * weight, 4.0 * 0x1p-22);
        }
}

TEST(Bloom, SeparablePassesAgreeWithTheDirectSum) {
    const RgbImage image = noise(40, 30);
    for (const BloomFilter filter : {BloomFilter::Box, BloomFilter::Gaussian}) {
        const int radius = 5;
        const std::vector<double> kernel = post::bloomKernel(filter, radius, 2.0);
        const RgbImage separable = post::bloomFiltered(image, kernel);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                RgbSum sum(0.0);
                for (int j = -radius; j <= radius; ++j)
                    for (int i = -radius; i <= radius; ++i) {
                        if (x + i < 0 || y + j < 0 || x + i >= image.width || y + j >= image.height) continue;
                        sum += kernel[static_cast<std::size_t>(i + radius)] *
                               kernel[static_cast<std::size_t>(j + radius)] * RgbSum(image.at(x + i, y + j));
                    }
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(separable.at(x, y)[c], sum[c], 1e-5 * sum[c]);
            }
    }
}

TEST(Bloom, ThresholdKeepsWholePixels) {
    RgbImage image(3, 1);
    image.at(0, 0) = {0.7f, 0.1f, 0.1f};
    image.at(1, 0) = {0.71f, 0.1f, 0.2f};
    image.at(2, 0) = {std::numeric_limits<float>::quiet_NaN(), 9.0f, 9.0f};
    const RgbImage bright = post::bloomThresholded(image, 0.7f);
    EXPECT_EQ(bright.at(0, 0), Rgb(0.0f));
    EXPECT_EQ(bright.at(1, 0), image.at(1, 0));
    EXPECT_EQ(bright.at(2, 0), Rgb(0.0f));  // would spread
}

TEST(Bloom, StagesAddUp) {
    const RgbImage image = noise(20, 20);
    Settings settings;
    settings.bloom = true;
    settings.bloomScale = 2.0f;
    const RgbImage result = post::applyBloom(image, settings);
    settings.bloomDebug = true;
    settings.bloomStage = BloomStage::Filtered;
    const RgbImage glow = post::applyBloom(image, settings);
    settings.bloomStage = BloomStage::Added;
    EXPECT_EQ(post::applyBloom(image, settings).pixels, result.pixels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(result.pixels[i], glow.pixels[i] + image.pixels[i]);
    settings.bloom = false;
    EXPECT_EQ(post::applyBloom(image, settings).pixels, image.pixels);
}

TEST(DisplayTransform, AppliesExposureForDisplayOnly) {
    const RgbImage image = noise(4, 4);
    Settings settings;
    settings.exposure = 1.0f;
    EXPECT_EQ(post::applyDisplayTransform(image, settings, false).pixels, image.pixels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(post::applyDisplayTransform(image, settings, true).pixels[i], 2.0f * image.pixels[i]);
}

TEST(Bloom, EndsAtAStop) {
    std::stop_source stop;
    stop.request_stop();
    const RgbImage image = noise(9, 7);
    Settings settings;
    EXPECT_EQ(post::applyBloom(image, settings, stop.get_token()).pixels, image.pixels);
    settings.bloom = true;
    EXPECT_THROW(post::applyBloom(image, settings, stop.get_token()), Stopped);
    EXPECT_THROW(post::applyDisplayTransform(image, settings, true, stop.get_token()), Stopped);
}

}  // namespace
}  // namespace rayscope
