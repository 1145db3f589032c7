// Verdicts on pixels, against differences that are known exactly and against a second implementation.
#include <gtest/gtest.h>

#include <rayscope/diagnostics.h>
#include <rayscope/verdict.h>
#include <cmath>
#include <random>

#include "image/srgb.h"

namespace rayscope {
namespace {

/// A grey image of one 8-bit code.
RgbImage grey(int width, int height, int code) {
    return {width, height, Rgb(image::decodeByte(static_cast<std::uint8_t>(code)))};
}

Rgb color(int r, int g, int b) {
    return {image::decodeByte(static_cast<std::uint8_t>(r)), image::decodeByte(static_cast<std::uint8_t>(g)),
            image::decodeByte(static_cast<std::uint8_t>(b))};
}

PixelRule tolerance(double value) {
    PixelRule rule;
    rule.tolerance = value;
    return rule;
}

TEST(Verdict, ADifferenceAsLargeAsTheToleranceIsAllowedForAllCodes) {
    for (int code = 0; code + 4 <= 255; ++code) {
        const RgbImage reference = grey(3, 2, code), image = grey(3, 2, code + 4);
        const PixelVerdict verdict = judgePixels(image, reference, tolerance(4.0 / 255.0));
        EXPECT_TRUE(verdict.passes) << code;
        EXPECT_EQ(verdict.largest, 4.0 / 255.0) << code;
        EXPECT_FALSE(judgePixels(image, reference, tolerance(std::nextafter(4.0 / 255.0, 0.0))).passes)
            << code;
    }
}

TEST(Verdict, TheLargestChannelCounts) {
    const RgbImage reference(1, 1, color(10, 20, 30));
    EXPECT_EQ(judgePixels({1, 1, color(11, 20, 30)}, reference, {}).largest, 1.0 / 255.0);
    EXPECT_EQ(judgePixels({1, 1, color(11, 17, 30)}, reference, {}).largest, 3.0 / 255.0);
    EXPECT_EQ(judgePixels({1, 1, color(11, 17, 90)}, reference, {}).largest, 60.0 / 255.0);
}

TEST(Verdict, AShareOfThePixelsMayDiffer) {
    RgbImage image = grey(20, 5, 100);
    const RgbImage reference = image;
    image.at(3, 1) = image.at(7, 4) = color(150, 100, 100);
    PixelRule rule;
    rule.share = 0.02;
    PixelVerdict verdict = judgePixels(image, reference, rule);
    EXPECT_TRUE(verdict.passes);
    EXPECT_EQ(verdict.differing, 2);
    EXPECT_EQ(verdict.share(), 0.02);
    EXPECT_EQ(verdict.largestX, 3);
    EXPECT_EQ(verdict.largestY, 1);
    rule.share = 0.019;
    EXPECT_FALSE(judgePixels(image, reference, rule).passes);

    rule.share = 1.0;
    rule.hardLimit = 50.0 / 255.0;
    EXPECT_TRUE(judgePixels(image, reference, rule).passes);
    rule.hardLimit = 49.0 / 255.0;
    verdict = judgePixels(image, reference, rule);
    EXPECT_FALSE(verdict.passes);
    EXPECT_EQ(verdict.overHardLimit, 2);
}

TEST(Verdict, AShiftByAPixelIsWithinTheNeighbourhood) {
    RgbImage image = grey(9, 9, 0), reference = image;
    image.at(4, 4) = reference.at(5, 4) = color(255, 255, 255);
    EXPECT_EQ(judgePixels(image, reference, {}).differing, 2);
    PixelRule rule;
    rule.neighbourhood = 3;
    EXPECT_EQ(judgePixels(image, reference, rule).differing, 0);
    // The reference shows something that the image does not have: only the way back finds it.
    image.at(4, 4) = color(0, 0, 0);
    EXPECT_EQ(judgePixels(image, reference, rule).differing, 1);
    EXPECT_EQ(judgePixels(reference, image, rule).differing, 1);
    // Two pixels away is outside 3 × 3 and inside 5 × 5.
    image.at(3, 4) = color(255, 255, 255);
    EXPECT_EQ(judgePixels(image, reference, rule).differing, 2);
    rule.neighbourhood = 5;
    EXPECT_EQ(judgePixels(image, reference, rule).differing, 0);
}

TEST(Verdict, PixelsThatAreNotFiniteFail) {
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        RgbImage image = grey(4, 4, 50);
        const RgbImage reference = image;
        image.at(1, 2).g = bad;
        PixelRule rule = tolerance(1.0);
        const PixelVerdict verdict = judgePixels(image, reference, rule);
        EXPECT_FALSE(verdict.passes);
        EXPECT_EQ(verdict.nonFinite, 1);
        EXPECT_EQ(verdict.differing, 1);
        EXPECT_EQ(verdict.meanDifference, 1.0 / 16.0);
        EXPECT_TRUE(std::isnan(differenceMap(image, reference, rule).at(1, 2)));
        EXPECT_EQ(differenceMap(image, reference, rule).at(1, 1), 0.0);
        rule.share = 1.0;
        EXPECT_TRUE(judgePixels(image, reference, rule).passes);
        rule.hardLimit = 100.0;
        EXPECT_FALSE(judgePixels(image, reference, rule).passes);
        EXPECT_FALSE(judgePixels(image, image, tolerance(0.0)).passes) << "NaN is not equal to itself";
    }
}

TEST(Verdict, LinearValuesAreComparedAsTheyAre) {
    PixelRule rule = tolerance(0.5);
    rule.values = ComparedValues::Linear;
    EXPECT_TRUE(judgePixels({1, 1, Rgb(10.5f)}, {1, 1, Rgb(10.0f)}, rule).passes);
    EXPECT_FALSE(judgePixels({1, 1, Rgb(10.75f)}, {1, 1, Rgb(10.0f)}, rule).passes);
    rule.values = ComparedValues::Display;
    EXPECT_TRUE(judgePixels({1, 1, Rgb(99.0f)}, {1, 1, Rgb(10.0f)}, tolerance(0.0)).passes) << "both white";
}

TEST(Verdict, TheScoreFallsToZeroAtAMeanDifferenceOfATenth) {
    EXPECT_EQ(judgePixels(grey(4, 4, 7), grey(4, 4, 7), {}).score(), 100.0);
    EXPECT_NEAR(judgePixels(grey(4, 4, 10), grey(4, 4, 7), {}).score(), 100.0 - 1000.0 * 3.0 / 255.0, 1e-9);
    EXPECT_EQ(judgePixels(grey(4, 4, 40), grey(4, 4, 7), {}).score(), 0.0);
}

/// The mean over pixels and channels of the smallest difference within 3 × 3, in both directions, in
/// integers.
double meanOfLeastDifferences(const Image<glm::ivec3>& a, const Image<glm::ivec3>& b) {
    const auto sum = [](const glm::ivec3& v) { return v.x + v.y + v.z; };
    const auto least = [&](const Image<glm::ivec3>& from, const Image<glm::ivec3>& to, int x, int y) {
        glm::ivec3 best(1000);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (x + dx < 0 || y + dy < 0 || x + dx >= to.width || y + dy >= to.height) continue;
                const glm::ivec3 d = glm::abs(from.at(x, y) - to.at(x + dx, y + dy));
                if (sum(d) < sum(best)) best = d;
            }
        return sum(best);
    };
    long long total = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) total += std::max(least(a, b, x, y), least(b, a, x, y));
    return static_cast<double>(total) / (3.0 * a.width * a.height);
}

TEST(Verdict, RandomPicturesHaveTheScoreOfIntegerArithmetic) {
    std::mt19937 random(4);
    for (int round = 0; round < 50; ++round) {
        Image<glm::ivec3> codes[2]{{13, 9}, {13, 9}};
        RgbImage images[2]{{13, 9}, {13, 9}};
        const int spread = 1 + round;
        for (std::size_t i = 0; i < codes[0].pixels.size(); ++i)
            for (int k = 0; k < 2; ++k) {
                glm::ivec3& c = codes[k].pixels[i];
                for (int channel = 0; channel < 3; ++channel)
                    c[channel] = static_cast<int>(random() % static_cast<unsigned>(spread)) + 100;
                images[k].pixels[i] = color(c.r, c.g, c.b);
            }
        PixelRule rule;
        rule.neighbourhood = 3;
        const double mean = meanOfLeastDifferences(codes[0], codes[1]);
        EXPECT_NEAR(judgePixels(images[0], images[1], rule).meanDifference, mean / 255.0, 1e-12);
    }
}

TEST(Verdict, WrongArgumentsAreNamed) {
    const RgbImage image = grey(2, 2, 1);
    EXPECT_THROW(judgePixels(image, grey(2, 3, 1), {}), InputError);
    EXPECT_THROW(judgePixels({}, {}, {}), InputError);
    EXPECT_THROW(judgePixels(image, image, tolerance(-1.0)), std::invalid_argument);
    EXPECT_THROW(judgePixels(image, image, tolerance(NAN)), std::invalid_argument);
    PixelRule rule;
    for (const int size : {0, 2, -3, 17}) {
        rule.neighbourhood = size;
        EXPECT_THROW(judgePixels(image, image, rule), std::invalid_argument) << size;
    }
    rule = {};
    rule.share = 1.5;
    EXPECT_THROW(judgePixels(image, image, rule), std::invalid_argument);
    rule = {};
    rule.hardLimit = NAN;
    EXPECT_THROW(judgePixels(image, image, rule), std::invalid_argument);
}

}  // namespace
}  // namespace rayscope
