#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
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

namespace {

/// The sRGB codes of the values between 0 and 1, without powers.
class SrgbCodes {
  public:
    SrgbCodes() {
        for (std::uint32_t code = 0; code < 256; ++code) first_[code] = firstOf(code);
        for (std::uint32_t i = 0; i < start_.size(); ++i)
            start_[i] = static_cast<std::uint8_t>(
                std::upper_bound(first_.begin(), first_.end(), i << kShift) - first_.begin() - 1);
    }

    std::uint8_t operator()(float linear) const {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(linear);
        std::uint32_t code = start_[bits >> kShift];
        while (code < 255 && bits >= first_[code + 1]) ++code;
        return static_cast<std::uint8_t>(code);
    }

  private:
    static constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0f), kShift = 16;

    /// The bits of the smallest value with this code; floats of at least 0 are ordered like their bits.
    static std::uint32_t firstOf(std::uint32_t code) {
        std::uint32_t from = 0, to = kOne;
        while (from < to) {
            const std::uint32_t middle = from + (to - from) / 2;
            const float encoded = 255.0f * linearToSrgb(std::bit_cast<float>(middle)) + 0.5f;
            if (static_cast<std::uint32_t>(encoded) >= code)
                to = middle;
            else
                from = middle + 1;
        }
        return from;
    }

    std::array<std::uint32_t, 256> first_{};
    std::array<std::uint8_t, (kOne >> kShift) + 1> start_{};  ///< the code at the start of a range of bits
};

}  // namespace

std::uint8_t encodeByte(float linear, Encoding encoding) {
    if (!(linear > 0.0f)) return 0;  // also NaN
    if (linear >= 1.0f) return 255;
    if (encoding == Encoding::None) return static_cast<std::uint8_t>(255.0f * linear);
    static const SrgbCodes codes;
    return codes(linear);
}

}  // namespace rayscope::image
