#include "post/display_transform.h"

#include <cmath>
#include <utility>

#include "base/file_suffix.h"
#include "post/bloom.h"

namespace rayscope::post {

RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings, bool forDisplay,
                               const std::stop_token& stop) {
    RgbImage image = applyBloom(mean, settings, stop);
    if (!forDisplay || settings.exposure == 0.0f) return image;
    return exposed(std::move(image), settings.exposure);
}

RgbImage exposed(RgbImage image, float exposure) {
    const float factor = std::exp2(exposure);
    for (Rgb& pixel : image.pixels) pixel *= factor;
    return image;
}

bool isDisplayFormat(std::string_view path) {
    return base::hasSuffix(path, ".png") || base::hasSuffix(path, ".ppm") || base::hasSuffix(path, ".pgm");
}

}  // namespace rayscope::post
