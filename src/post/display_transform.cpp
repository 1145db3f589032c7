#include "post/display_transform.h"

#include <cmath>

#include "base/file_suffix.h"
#include "post/bloom.h"

namespace rayscope::post {

RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings, bool forDisplay) {
    RgbImage image = applyBloom(mean, settings);
    if (!forDisplay || settings.exposure == 0.0f) return image;
    const float factor = std::exp2(settings.exposure);
    for (Rgb& pixel : image.pixels) pixel *= factor;
    return image;
}

bool isDisplayFormat(std::string_view path) {
    return base::hasSuffix(path, ".png") || base::hasSuffix(path, ".ppm") || base::hasSuffix(path, ".pgm");
}

}  // namespace rayscope::post
