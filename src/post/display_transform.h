#pragma once
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <string_view>

namespace rayscope::post {

/// The film's mean as a file should hold it: with bloom; and with exposure if `forDisplay`, that is for
/// formats whose values are meant to be looked at rather than computed with.
RgbImage develop(const RgbImage& mean, const Settings& settings, bool forDisplay);

/// Whether the suffix of a file name stands for an 8-bit format.
bool isDisplayFormat(std::string_view path);

}  // namespace rayscope::post
