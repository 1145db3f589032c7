#include "sampling/sample_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace rayscope {
namespace {

constexpr SamplePattern kPatterns[] = {SamplePattern::Independent, SamplePattern::Jittered,
                                       SamplePattern::Sobol};

TEST(SampleStream, IsAPureFunctionOfItsArguments) {
    for (const SamplePattern pattern : kPatterns) {
        const sampling::SampleStream a(pattern, 7, 3, 4, 5, 16), b(pattern, 7, 3, 4, 5, 16);
        a.get2D(sampling::Dim::Light, sampling::PathKey{}.child(3), 2, 1,
                16);  // without effect on later calls
        EXPECT_EQ(a.get2D(sampling::Dim::Pixel), b.get2D(sampling::Dim::Pixel));
        EXPECT_NE(a.get2D(sampling::Dim::Pixel), a.get2D(sampling::Dim::Lens));
        EXPECT_NE(a.get2D(sampling::Dim::Pixel),
                  sampling::SampleStream(pattern, 8, 3, 4, 5, 16).get2D(sampling::Dim::Pixel));
        EXPECT_NE(a.get2D(sampling::Dim::Pixel),
                  sampling::SampleStream(pattern, 7, 4, 3, 5, 16).get2D(sampling::Dim::Pixel));
        EXPECT_NE(a.get2D(sampling::Dim::Light, {}, 0), a.get2D(sampling::Dim::Light, {}, 1));
    }
}

/// Pearson's statistic of 16 × 16 cells, 255 degrees of freedom: mean 255, standard deviation 22.6.
double chiSquare(const std::vector<glm::vec2>& points) {
    std::vector<int> count(256, 0);
    for (const glm::vec2& p : points)
        ++count[static_cast<std::size_t>(static_cast<int>(p.y * 16) * 16 + static_cast<int>(p.x * 16))];
    const double expected = static_cast<double>(points.size()) / 256.0;
    double sum = 0.0;
    for (const int c : count) sum += (c - expected) * (c - expected) / expected;
    return sum;
}

TEST(SampleStream, IsUniformOverPixelsInEveryDimension) {
    for (const SamplePattern pattern : kPatterns) {
        for (const sampling::Dim dim : {sampling::Dim::Pixel, sampling::Dim::Lens, sampling::Dim::Time,
                                        sampling::Dim::Light, sampling::Dim::Glossy}) {
            std::vector<glm::vec2> points;
            for (int y = 0; y < 160; ++y)
                for (int x = 0; x < 160; ++x)
                    points.push_back(sampling::SampleStream(pattern, 1, x, y, 3, 16).get2D(dim));
            for (const glm::vec2& p : points) {
                ASSERT_GE(std::min(p.x, p.y), 0.0f);
                ASSERT_LT(std::max(p.x, p.y), 1.0f);
            }
            EXPECT_LT(chiSquare(points), 255.0 + 5.0 * 22.6)
                << static_cast<int>(pattern) << static_cast<int>(dim);
        }
    }
}

TEST(SampleStream, NeighbouringPixelsAreNotCorrelated) {
    for (const SamplePattern pattern : kPatterns) {
        double sum = 0.0;
        constexpr int kCount = 40000;
        for (int x = 0; x < kCount; ++x) {
            const glm::vec2 a = sampling::SampleStream(pattern, 1, x, 0, 0, 16).get2D(sampling::Dim::Pixel);
            const glm::vec2 b =
                sampling::SampleStream(pattern, 1, x + 1, 0, 0, 16).get2D(sampling::Dim::Pixel);
            sum += (static_cast<double>(a.x) - 0.5) * (static_cast<double>(b.x) - 0.5) * 12.0;
        }
        EXPECT_LT(std::abs(sum / kCount), 4.0 / std::sqrt(kCount)) << static_cast<int>(pattern);
    }
}

/// Number of cells of a rows × columns grid that contain exactly one point.
int filledCells(const std::vector<glm::vec2>& points, int columns, int rows) {
    std::set<int> cells;
    for (const glm::vec2& p : points)
        cells.insert(static_cast<int>(p.y * static_cast<float>(rows)) * columns +
                     static_cast<int>(p.x * static_cast<float>(columns)));
    return static_cast<int>(cells.size());
}

TEST(SampleStream, JitteredAndSobolSamplesOfAPixelAreStratified) {
    for (const SamplePattern pattern : {SamplePattern::Jittered, SamplePattern::Sobol}) {
        std::vector<glm::vec2> overPixel, ofOneSample;
        for (int i = 0; i < 16; ++i) {
            overPixel.push_back(sampling::SampleStream(pattern, 9, 5, 6, i, 16).get2D(sampling::Dim::Pixel));
            ofOneSample.push_back(sampling::SampleStream(pattern, 9, 5, 6, 3, 4)
                                      .get2D(sampling::Dim::Light, sampling::PathKey{}.child(1), 1, i, 16));
        }
        EXPECT_EQ(filledCells(overPixel, 4, 4), 16);
        EXPECT_EQ(filledCells(ofOneSample, 4, 4), 16);
    }
}

TEST(SampleStream, JitteredNonSquareCountsFillTheirGrid) {
    for (const auto& [n, columns, rows] : {std::tuple{12, 4, 3}, {7, 7, 1}, {18, 6, 3}, {1, 1, 1}}) {
        std::vector<glm::vec2> points;
        for (int i = 0; i < n; ++i)
            points.push_back(
                sampling::SampleStream(SamplePattern::Jittered, 2, 1, 1, i, n).get2D(sampling::Dim::Pixel));
        EXPECT_EQ(filledCells(points, columns, rows), n);
    }
}

TEST(SampleStream, OneDimensionalSamplesAreStratified) {
    for (const SamplePattern pattern : {SamplePattern::Jittered, SamplePattern::Sobol}) {
        std::set<int> cells;
        for (int k = 0; k < 32; ++k)
            cells.insert(static_cast<int>(
                32.0f * sampling::SampleStream(pattern, 2, 1, 1, 0, 4)
                            .get1D(sampling::Dim::Light, sampling::PathKey{}.child(9), 0, k, 32)));
        EXPECT_EQ(cells.size(), 32u);
    }
}

TEST(PathKey, BranchesDiffer) {
    std::set<std::uint32_t> keys{0};
    for (std::uint32_t i = 0; i < 1000; ++i) keys.insert(sampling::PathKey{}.child(i).value);
    EXPECT_EQ(keys.size(), 1001u);
    EXPECT_NE(sampling::PathKey{}.child(1).child(2).value, sampling::PathKey{}.child(2).child(1).value);
}

}  // namespace
}  // namespace rayscope
