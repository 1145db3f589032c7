#include <rayscope/display.h>

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

}  // namespace rayscope
