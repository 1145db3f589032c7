#pragma once
#include <rayscope/render_image.h>

namespace rayscope::cli {

/// Prints the pixels that are NaN or infinite, with the cause and the probe command of the first. Returns
/// whether there are any.
bool reportNonFinite(const RenderedImage& image);

}  // namespace rayscope::cli
