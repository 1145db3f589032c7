#include "post/display_transform.h"

#include <cmath>

#include "post/bloom.h"

namespace rayscope::post {

RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings, bool forDisplay) {
    RgbImage image = applyBloom(mean, settings);
    if (!forDisplay || settings.exposure == 0.0f) return image;
    const float factor = std::exp2(settings.exposure);
    for (Rgb& pixel : image.pixels) pixel *= factor;
    return image;
}

bool isDisplayFormat(std::string_view path) { return path.ends_with(".png") || path.ends_with(".PNG"); }

}  // namespace rayscope::post
