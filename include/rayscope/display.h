#pragma once
// From linear radiance to what a display or an image file shows.
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <string>
#include <string_view>

namespace rayscope {

/// Applies bloom, then exposure, with the values of the settings. The result is linear: the encoding is
/// applied by writeImage().
RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings);

/// Writes a rendered image as `rayscope render -o` does: with bloom; .png, .ppm and .pgm also with the
/// exposure and the encoding of the settings, while .exr, .pfm and .hdr hold linear values. Throws InputError
/// like writeImage().
void writeRenderedImage(const std::string& path, const RgbImage& mean, const Settings& settings,
                        const ImageMetadata& metadata = {});

/// The file that writeRenderedImage() would write, for a suffix such as ".png".
std::string encodeRenderedImage(const std::string& suffix, const RgbImage& mean, const Settings& settings,
                                const ImageMetadata& metadata = {});

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

/// Values from 0 to 1 as a display shows them, with the sRGB curve, of linear ones, and the inverse. Values
/// are not clamped.
Rgb toDisplay(const Rgb& linear);
Rgb fromDisplay(const Rgb& shown);

}  // namespace rayscope
