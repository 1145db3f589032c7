#include <rayscope/display.h>

#include "post/display_transform.h"

namespace rayscope {

RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings) {
    return post::develop(mean, settings, true);
}

void writeRenderedImage(const std::string& path, const RgbImage& mean, const Settings& settings,
                        const ImageMetadata& metadata) {
    writeImage(path, post::develop(mean, settings, post::isDisplayFormat(path)), metadata, settings.tone);
}

}  // namespace rayscope
