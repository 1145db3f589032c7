#pragma once
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <stop_token>
#include <string_view>

namespace rayscope::post {

/// Applies bloom to the mean of the film and, if `forDisplay`, exposure. Exposure is for display formats
/// only, so that linear formats keep radiance. The encoding is applied when the image is written. Throws
/// Stopped within some milliseconds of a stop, while bloom is applied.
RgbImage applyDisplayTransform(const RgbImage& mean, const Settings& settings, bool forDisplay,
                               const std::stop_token& stop = {});

/// The image with the exposure, in powers of 2.
RgbImage exposed(RgbImage image, float exposure);

/// Whether the suffix of the path is that of an 8-bit display format.
bool isDisplayFormat(std::string_view path);

}  // namespace rayscope::post
