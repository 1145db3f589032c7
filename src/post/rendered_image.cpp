#include <rayscope/display.h>

#include "image/srgb.h"
#include "post/display_transform.h"

namespace rayscope {

RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings) {
    return post::applyDisplayTransform(mean, settings, true);
}

void writeRenderedImage(const std::string& path, const RgbImage& mean, const Settings& settings,
                        const ImageMetadata& metadata) {
    writeImage(path, post::applyDisplayTransform(mean, settings, post::isDisplayFormat(path)), metadata,
               settings.tone);
}

std::string encodeRenderedImage(const std::string& suffix, const RgbImage& mean, const Settings& settings,
                                const ImageMetadata& metadata) {
    const bool forDisplay = post::isDisplayFormat("image" + suffix);
    return encodeImage(suffix, post::applyDisplayTransform(mean, settings, forDisplay), metadata,
                       settings.tone);
}

Rgb toDisplay(const Rgb& linear) {
    return {image::linearToSrgb(linear.r), image::linearToSrgb(linear.g), image::linearToSrgb(linear.b)};
}

Rgb fromDisplay(const Rgb& shown) {
    return {image::srgbToLinear(shown.r), image::srgbToLinear(shown.g), image::srgbToLinear(shown.b)};
}

}  // namespace rayscope
