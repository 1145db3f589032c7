#pragma once
#include <rayscope/image.h>

namespace rayscope::image {

/// Throws InputError if the sizes differ or there are no pixels, and std::invalid_argument unless
/// hasAllPixels().
void checkComparable(const RgbImage& image, const RgbImage& reference);

}  // namespace rayscope::image
