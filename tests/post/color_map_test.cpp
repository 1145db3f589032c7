#include <rayscope/display.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rayscope {
namespace {

constexpr ColorMap kMaps[] = {ColorMap::Spectrum, ColorMap::BlueGold, ColorMap::Grey};

double luminance(const Rgb& c) {
    return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
           0.0722 * static_cast<double>(c.b);
}

TEST(ColorMap, LuminanceIsMonotonicAndColoursAreInGamut) {
    for (const ColorMap map : kMaps) {
        double before = -1.0;
        for (int i = 0; i <= 1000; ++i) {
            const Rgb color = mapColor(map, i / 1000.0);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_GE(color[channel], 0.0f);
                EXPECT_LE(color[channel], 1.0f);
            }
            EXPECT_GT(luminance(color), before) << kColorMapNames[static_cast<int>(map)] << " " << i;
            before = luminance(color);
        }
    }
}

/// Simulates deuteranopia after Machado, Oliveira and Fernandes 2009.
Rgb simulateDeuteranopia(const Rgb& c) {
    return {0.367322f * c.r + 0.860646f * c.g - 0.227968f * c.b,
            0.280085f * c.r + 0.672501f * c.g + 0.047413f * c.b,
            -0.011820f * c.r + 0.042940f * c.g + 0.968881f * c.b};
}

TEST(ColorMap, KeepsTheOrderWithDeuteranopia) {
    for (const ColorMap map : kMaps) {
        double before = -1.0;
        for (int i = 0; i <= 100; ++i) {
            const double seen = luminance(simulateDeuteranopia(mapColor(map, i / 100.0)));
            EXPECT_GT(seen, before) << kColorMapNames[static_cast<int>(map)] << " " << i;
            before = seen;
        }
    }
}

TEST(ColorMap, ClampsToTheRangeAndMapsNanToMagenta) {
    for (const ColorMap map : kMaps) {
        EXPECT_EQ(mapColor(map, -5.0), mapColor(map, 0.0));
        EXPECT_EQ(mapColor(map, std::numeric_limits<double>::infinity()), mapColor(map, 1.0));
        EXPECT_EQ(mapColor(map, std::nan("")), Rgb(1.0f, 0.0f, 1.0f));
    }
}

TEST(ColorMap, BlueAndGoldAvoidsRedAndGreen) {
    const Rgb low = mapColor(ColorMap::BlueGold, 0.0), high = mapColor(ColorMap::BlueGold, 1.0);
    EXPECT_GT(low.b, 2.0f * low.r);
    EXPECT_GT(high.r, 1.5f * high.b);
}

}  // namespace
}  // namespace rayscope
