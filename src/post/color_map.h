#pragma once
#include <rayscope/vector.h>

#include <string_view>

namespace rayscope::post {

/// False-colour maps. The lightness of all three increases monotonically, so that the order of values is kept
/// in greyscale and with colour vision deficiencies.
enum class ColorMap {
    Spectrum,  ///< dark violet through green to yellow
    BlueGold,  ///< dark blue through grey to gold, without red and green
    Grey
};
inline constexpr std::string_view kColorMapNames[] = {"spectrum", "blue-gold", "grey"};

/// Linear colour of a value, clamped to 0 … 1. NaN is magenta, which no map contains. Computed along a path
/// in Oklab (Ottosson 2020, "A perceptual color space for image processing").
Rgb mapColor(ColorMap map, double value);

}  // namespace rayscope::post
