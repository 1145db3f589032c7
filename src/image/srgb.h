#pragma once
#include <rayscope/image.h>
#include <cstdint>

namespace rayscope::image {

/// The two directions of the piecewise curve of IEC 61966-2-1, for values from 0 to 1.
float srgbToLinear(float encoded);
float linearToSrgb(float linear);

/// The linear value of an 8-bit sRGB code.
float decodeByte(std::uint8_t code);

/// The 8-bit code of a linear value: with Srgb the nearest one, with None the one below. Values outside 0 …
/// 1 are clamped and NaN becomes 0.
std::uint8_t encodeByte(float linear, Encoding curve);

}  // namespace rayscope::image
