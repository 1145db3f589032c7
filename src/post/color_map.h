#pragma once
#include <rayscope/vector.h>

#include <string_view>

namespace rayscope::post {

/// How a number becomes a colour. All three grow evenly in lightness, so that people with any colour vision,
/// and black-and-white prints, keep the order of the values.
enum class ColorMap {
    Spectrum,  ///< dark violet over green to yellow
    BlueGold,  ///< dark blue over grey to gold: no red and green at all
    Grey
};
inline constexpr std::string_view kColorMapNames[] = {"spectrum", "blue-gold", "grey"};

/// Linear colour of a share 0 … 1 of the range; beyond it the ends. NaN is magenta, which no map contains.
/// Computed along a path in Oklab (Ottosson 2020, "A perceptual color space for image processing").
Rgb mapColor(ColorMap map, double share);

}  // namespace rayscope::post
