#pragma once
#include <rayscope/image.h>
#include <cstdint>
#include <vector>

namespace rayscope::image {

/// The piecewise sRGB transfer function of IEC 61966-2-1 and its inverse, for values from 0 to 1.
float srgbToLinear(float encoded);
float linearToSrgb(float linear);

/// The linear value, 0 … 1, of an 8-bit sRGB code.
float decodeByte(std::uint8_t code);

/// The linear values, 0 … 1, of the codes 0 … maximum, as floats nearest to the exact ones.
std::vector<float> srgbTable(std::uint32_t maximum);

/// The 8-bit code of a linear value: the nearest code with Srgb, the truncated one with None. Values outside
/// 0 … 1 are clamped; NaN becomes 0.
std::uint8_t encodeByte(float linear, Encoding encoding);

}  // namespace rayscope::image
