#include "sampling/sobol.h"

#include <gtest/gtest.h>

#include <vector>

#include "sampling/hash.h"

namespace rayscope {
namespace {

/// Every elementary interval of 2^a × 2^(m − a) boxes holds exactly one of the first 2^m points of a (0, m,
/// 2)-net.
bool isNet(int m, int dimX, int dimY, std::uint32_t seedX, std::uint32_t seedY) {
    for (int a = 0; a <= m; ++a) {
        std::vector<int> count(std::size_t{1} << m, 0);
        for (std::uint32_t i = 0; i < (1u << m); ++i) {
            const std::uint64_t x =
                seedX ? sampling::owenScramble(sampling::sobol(i, dimX), seedX) : sampling::sobol(i, dimX);
            const std::uint64_t y =
                seedY ? sampling::owenScramble(sampling::sobol(i, dimY), seedY) : sampling::sobol(i, dimY);
            const std::uint64_t column = (x << a) >> 32, row = (y << (m - a)) >> 32;
            ++count[(row << a) + column];
        }
        for (const int c : count)
            if (c != 1) return false;
    }
    return true;
}

TEST(Sobol, HasTheKnownFirstPoints) {
    const double expected[4][4] = {
        {0, 0, 0, 0}, {.5, .5, .5, .5}, {.25, .75, .25, .75}, {.75, .25, .75, .25}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(sampling::sobol(i, 0) * 0x1p-32, expected[i][0]);
        EXPECT_EQ(sampling::sobol(i, 1) * 0x1p-32, expected[i][1]);
    }
}

TEST(Sobol, FirstTwoDimensionsAreANetWithAndWithoutScrambling) {
    for (int m = 0; m <= 10; ++m) {
        EXPECT_TRUE(isNet(m, 0, 1, 0, 0)) << m;
        EXPECT_TRUE(isNet(m, 0, 1, 0x9e3779b9u, 0x12345u)) << m;
    }
}

TEST(Sobol, EachDimensionIsStratified) {
    for (int dimension = 0; dimension < sampling::kSobolDimensions; ++dimension) {
        std::vector<int> count(1024, 0);
        for (std::uint32_t i = 0; i < 1024; ++i)
            ++count[sampling::owenScramble(sampling::sobol(i, dimension), 77u) >> 22];
        for (const int c : count) EXPECT_EQ(c, 1) << dimension;
    }
}

TEST(Sobol, ControlTheNetTestRejectsOtherPatterns) { EXPECT_FALSE(isNet(4, 0, 0, 0, 0)); }

TEST(Hash, UnitFloatsAreBelowOne) {
    EXPECT_LT(sampling::toUnitFloat(0xffffffffu), 1.0f);
    EXPECT_EQ(sampling::toUnitFloat(0), 0.0f);
}

}  // namespace
}  // namespace rayscope
