// Error metrics against closed forms, values of the authors' own programs, and direct sums.
#include <gtest/gtest.h>

#include <rayscope/compare.h>
#include <cmath>

#include "image/srgb.h"
#include "image/test_images.h"
#include "support/expect_input_error.h"
#include "support/non_finite.h"

namespace rayscope {
namespace {

using test::kInfinity;

RgbImage plain(int width, int height, const Rgb& color) { return RgbImage(width, height, color); }

/// A white square on black whose left edge is at x0.
RgbImage whiteSquare(int x0) {
    RgbImage image(256, 256, Rgb(0.0f));
    for (int y = 64; y < 192; ++y)
        for (int x = x0; x < x0 + 128; ++x) image.at(x, y) = Rgb(1.0f);
    return image;
}

TEST(Compare, EqualImagesHaveNoError) {
    const RgbImage image = test::gradient(40, 30, 3.0f);
    const ErrorMeasures errors = measureErrors(image, image);
    for (const std::string_view name : errorMetricNames())
        EXPECT_NEAR(errors.of(errorMetricNamed(name)), 0.0, 1e-12) << name;
    EXPECT_EQ(errors.pixelsCompared, 40 * 30);
}

TEST(Compare, LinearMetricsOfAKnownDifference) {
    RgbImage reference = plain(10, 10, Rgb(0.5f)), image = reference;
    for (Rgb& pixel : image.pixels) pixel += Rgb(0.25f);
    image.at(3, 7) = Rgb(0.5f, 0.5f, 1.5f);
    const ErrorMeasures errors = measureErrors(image, reference);
    const double squares = 99 * 3 * 0.0625 + 1.0, sum = 99 * 3 * 0.25 + 1.0;
    EXPECT_NEAR(errors.rmse, std::sqrt(squares / 300.0), 1e-12);
    EXPECT_NEAR(errors.meanDifference, sum / 300.0, 1e-12);
    EXPECT_NEAR(errors.relMse, squares / 300.0 / 0.26, 1e-12);
    EXPECT_NEAR(errors.smape, (99 * 3 * 0.25 / 1.26 + 1.0 / 2.01) / 300.0, 1e-12);
    EXPECT_DOUBLE_EQ(errors.maximum, 1.0);
    EXPECT_EQ(errors.maximumX, 3);
    EXPECT_EQ(errors.maximumY, 7);
}

TEST(Compare, TheTrimmedMeanDropsOneInAThousand) {
    RgbImage reference = plain(100, 100, Rgb(0.0f)), image = reference;
    for (int i = 0; i < 10; ++i) image.at(i, 0) = Rgb(100.0f);
    image.at(0, 1) = Rgb(0.1f);
    const ErrorMeasures errors = measureErrors(image, reference);
    EXPECT_NEAR(errors.relMse, (10 * 1e6 + 1.0) / 1e4, 1e-3);
    EXPECT_NEAR(errors.relMseTrimmed, 1.0 / 9990.0, 1e-9);
}

TEST(Compare, SsimOfFlatImagesHasAClosedForm) {
    const RgbImage a = plain(20, 20, Rgb(0.2f)), b = plain(20, 20, Rgb(0.6f));
    const double ma = static_cast<double>(image::linearToSrgb(0.2f)),
                 mb = static_cast<double>(image::linearToSrgb(0.6f));
    EXPECT_NEAR(measureErrors(a, b).ssim, (2 * ma * mb + 1e-4) / (ma * ma + mb * mb + 1e-4), 1e-6);
}

TEST(Compare, SsimIsTheDirectSumOverItsWindow) {
    const RgbImage a = test::gradient(31, 29);
    RgbImage b = a;
    for (std::size_t i = 0; i < b.pixels.size(); ++i) b.pixels[i] *= i % 3 == 0 ? 0.5f : 0.9f;
    const auto value = [](const RgbImage& image, int x, int y) {
        const Rgb& c = image.at(x, y);
        return static_cast<double>(image::linearToSrgb(0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z));
    };
    const int x = 14, y = 12;
    double weights = 0, ma = 0, mb = 0;
    for (int j = -5; j <= 5; ++j)
        for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5);
            weights += w, ma += w * value(a, x + i, y + j), mb += w * value(b, x + i, y + j);
        }
    ma /= weights, mb /= weights;
    double va = 0, vb = 0, cov = 0;
    for (int j = -5; j <= 5; ++j)
        for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5) / weights;
            const double da = value(a, x + i, y + j) - ma, db = value(b, x + i, y + j) - mb;
            va += w * da * da, vb += w * db * db, cov += w * da * db;
        }
    const double ssim =
        (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
    EXPECT_NEAR(errorMap(a, b, ErrorMetric::Ssim).at(x, y), 1.0 - ssim, 1e-9);
}

// Values of the authors' program (github.com/NVlabs/flip) on the same images; the means of two
// implementations should agree to 1e-4.
TEST(Compare, FlipAgreesWithItsAuthorsOnAShiftedSquare) {
    const Image<double> map = errorMap(whiteSquare(65), whiteSquare(64), ErrorMetric::Flip);
    EXPECT_NEAR(scoreOf(map, ErrorMetric::Flip), 0.013150, 1e-5);
    EXPECT_NEAR(scoreOf(map, ErrorMetric::Max), 0.772917, 1e-4);
}

TEST(Compare, FlipAgreesWithItsAuthorsOnFlatColours) {
    const float grey = image::decodeByte(128), red = image::decodeByte(138);
    const RgbImage a = plain(64, 64, Rgb(grey)), b = plain(64, 64, Rgb(red, grey, grey));
    EXPECT_NEAR(measureErrors(b, a).flip, 0.125606, 1e-4);
}

TEST(Compare, FlipOfBlackAndWhiteIsAlmostOne) {
    // Green and blue have the largest redistributed difference; black and white are close to it.
    EXPECT_GT(measureErrors(plain(32, 32, Rgb(0.0f)), plain(32, 32, Rgb(1.0f))).flip, 0.9);
    EXPECT_LE(measureErrors(plain(32, 32, Rgb(0, 1, 0)), plain(32, 32, Rgb(0, 0, 1))).flip, 1.0 + 1e-9);
}

TEST(Compare, FlipIsSymmetricAndDependsOnExposure) {
    const RgbImage a = test::gradient(50, 40), b = plain(50, 40, Rgb(0.3f));
    EXPECT_NEAR(measureErrors(a, b).flip, measureErrors(b, a).flip, 1e-12);
    CompareOptions dark;
    dark.exposure = -3.0f;
    EXPECT_NE(measureErrors(a, b, dark).flip, measureErrors(a, b).flip);
    EXPECT_EQ(measureErrors(a, b, dark).rmse, measureErrors(a, b).rmse);
}

TEST(Compare, SkipsAndCountsNonFinitePixels) {
    const RgbImage reference = plain(32, 32, Rgb(0.5f));
    RgbImage image = reference;
    image.at(4, 4) = Rgb(NAN, 0.0f, 0.0f);
    image.at(5, 4) = Rgb(kInfinity);
    const ErrorMeasures errors = measureErrors(image, reference);
    EXPECT_EQ(errors.nonFiniteImage, 2);
    EXPECT_EQ(errors.nonFiniteReference, 0);
    EXPECT_EQ(errors.pixelsCompared, 32 * 32 - 2);
    for (const std::string_view name : errorMetricNames())
        EXPECT_NEAR(errors.of(errorMetricNamed(name)), 0.0, 1e-12) << name << ": spread to a neighbour";
    EXPECT_TRUE(std::isnan(errorMap(image, reference, ErrorMetric::Flip).at(4, 4)));
}

TEST(Compare, ScoreIsNanWithoutFinitePixels) {
    const ErrorMeasures errors = measureErrors(plain(8, 8, Rgb(NAN)), plain(8, 8, Rgb(0.0f)));
    for (const std::string_view name : errorMetricNames())
        EXPECT_TRUE(std::isnan(errors.of(errorMetricNamed(name)))) << name;
    EXPECT_EQ(errors.pixelsCompared, 0);
}

TEST(Compare, HandlesOnePixelAndHugeValues) {
    const ErrorMeasures one = measureErrors(plain(1, 1, Rgb(3.0f)), plain(1, 1, Rgb(1.0f)));
    EXPECT_NEAR(one.rmse, 2.0, 1e-12);
    EXPECT_NEAR(one.flip, 0.0, 1e-12) << "both clamp to white";
    const ErrorMeasures huge = measureErrors(plain(4, 4, Rgb(3e38f)), plain(4, 4, Rgb(-3e38f)));
    EXPECT_NEAR(huge.rmse / 6e38, 1.0, 1e-6);
    EXPECT_TRUE(std::isfinite(huge.smape));
}

TEST(Compare, ImagesOfDifferentSizeAreAnError) {
    const std::string error =
        test::inputErrorOf([] { measureErrors(plain(3, 2, Rgb(0)), plain(2, 3, Rgb(0))); });
    EXPECT_NE(error.find("3 x 2 and 2 x 3"), std::string::npos) << error;
    EXPECT_NE(test::inputErrorOf([] { errorMetricNamed("rsme"); }).find("'rmse'"), std::string::npos);
}

TEST(Compare, ScoreOfARegionEqualsThatOfTheCroppedImage) {
    const RgbImage a = test::gradient(20, 20), b = plain(20, 20, Rgb(0.25f));
    const Image<double> map = errorMap(a, b, ErrorMetric::Rmse);
    double squares = 0.0;
    for (int y = 3; y < 9; ++y)
        for (int x = 5; x < 10; ++x) {
            const glm::dvec3 d = glm::dvec3(a.at(x, y)) - 0.25;
            squares += glm::dot(d, d) / 3.0;
        }
    EXPECT_NEAR(scoreOf(map, ErrorMetric::Rmse, {5, 10, 3, 9}), std::sqrt(squares / 30.0), 1e-9);
}

TEST(Compare, ColourMapIsMonotonicAndMarksNonFiniteValues) {
    Image<double> map(101, 1);
    for (int x = 0; x <= 100; ++x) map.at(x, 0) = 0.02 * x;
    const RgbImage colors = applyColorMap(map, 2.0);
    // The lightness is linear in the weights of the paper, which apply to encoded values.
    double before = -1e-3;
    for (const Rgb& c : colors.pixels) {
        const double lightness = 0.30 * static_cast<double>(image::linearToSrgb(c.x)) +
                                 0.59 * static_cast<double>(image::linearToSrgb(c.y)) +
                                 0.11 * static_cast<double>(image::linearToSrgb(c.z));
        EXPECT_GT(lightness, before);
        before = lightness;
    }
    EXPECT_EQ(colors.at(0, 0), Rgb(0.0f));
    EXPECT_EQ(colors.at(100, 0), Rgb(1.0f));
    EXPECT_EQ(applyColorMap(Image<double>(1, 1, NAN), 1.0).at(0, 0), Rgb(1.0f, 0.0f, 1.0f));
}

TEST(Compare, InvalidArgumentsThrow) {
    const RgbImage image(20, 20);
    RgbImage lacking(20, 20);
    lacking.pixels.resize(2);
    for (const double value : {0.0, -5.0, 1e9, static_cast<double>(NAN)})
        EXPECT_THROW(measureErrors(image, image, {.pixelsPerDegree = value}), std::invalid_argument) << value;
    EXPECT_THROW(measureErrors(image, image, {.exposure = NAN}), std::invalid_argument);
    EXPECT_THROW(errorMap(image, lacking, ErrorMetric::Rmse), std::invalid_argument);
    EXPECT_THROW(errorMap(image, image, static_cast<ErrorMetric>(99)), std::invalid_argument);
    const Image<double> map(4, 4, 1.0);
    EXPECT_THROW(scoreOf(map, ErrorMetric::Rmse, {-10, 100, -10, 100}), std::invalid_argument);
    EXPECT_TRUE(std::isnan(scoreOf(map, ErrorMetric::Rmse, {3, 1, 3, 1})));
    EXPECT_THROW(RgbImage(-1, -1), std::invalid_argument);
    for (const char* name : {"a.png", "a.exr", "a.pfm", "a.hdr"})
        EXPECT_THROW(writeImage(name, lacking), std::invalid_argument) << name;
}

}  // namespace
}  // namespace rayscope
