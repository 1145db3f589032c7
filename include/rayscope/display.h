#pragma once
// From linear radiance to what a display or an image file shows.
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <string>

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

}  // namespace rayscope
