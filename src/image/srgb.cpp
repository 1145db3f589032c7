#include "image/srgb.h"

#include <cmath>

namespace rayscope::image {

float srgbToLinear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linearToSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

std::vector<float> srgbTable(std::uint32_t maximum) {
    std::vector<float> linear(maximum + 1);
    for (std::size_t code = 0; code < linear.size(); ++code) {
        const double encoded = static_cast<double>(code) / maximum;
        linear[code] = static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                             : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return linear;
}

float decodeByte(std::uint8_t code) {
    static const std::vector<float> table = srgbTable(255);
    return table[code];
}

std::uint8_t encodeByte(float linear, Encoding encoding) {
    if (!(linear > 0.0f)) return 0;  // also NaN
    if (linear >= 1.0f) return 255;
    if (encoding == Encoding::None) return static_cast<std::uint8_t>(255.0f * linear);
    return static_cast<std::uint8_t>(255.0f * linearToSrgb(linear) + 0.5f);
}

}  // namespace rayscope::image
