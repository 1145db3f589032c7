#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "image/codecs/codecs.h"

namespace rayscope::image {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// The nearest pixel with a common exponent. Negative values, NaN and values below 2^-128 become 0, values
/// above the range the largest value. The largest mantissa is at least 128, so that no pixel looks like a
/// run.
Rgbe encode(const Rgb& color) {
    constexpr float kLargest = 255.0f * 0x1p119f;  // exponent 255
    constexpr int kMinExponent = -127, kBias = 128;
    std::array<float, 3> values;
    for (int c = 0; c < 3; ++c)
        values[static_cast<std::size_t>(c)] = color[c] > 0.0f ? std::min(color[c], kLargest) : 0.0f;
    const float largest = *std::max_element(values.begin(), values.end());
    int exponent;
    std::frexp(largest, &exponent);
    const auto mantissa = [&](float value) {
        return static_cast<int>(std::lround(std::ldexp(value, 8 - exponent)));
    };
    if (mantissa(largest) > 255) ++exponent;
    if (largest == 0.0f || exponent < kMinExponent) return {};
    Rgbe pixel{};
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(mantissa(values[c]));
    pixel[3] = static_cast<std::uint8_t>(exponent + kBias);
    return pixel;
}

/// One channel of a scan line in runs, with codes above 128, and literal bytes.
void appendChannel(std::string& file, const std::vector<Rgbe>& line, std::size_t channel) {
    constexpr std::size_t kMaxRun = 127, kMaxLiteral = 128, kShortestRun = 4;
    const auto runAt = [&](std::size_t x) {
        std::size_t end = x + 1;
        while (end < line.size() && end - x < kMaxRun && line[end][channel] == line[x][channel]) ++end;
        return end - x;
    };
    for (std::size_t x = 0; x < line.size();) {
        if (const std::size_t run = runAt(x); run >= kShortestRun) {
            file += static_cast<char>(128 + run);
            file += static_cast<char>(line[x][channel]);
            x += run;
            continue;
        }
        std::size_t end = x + 1;
        while (end < line.size() && end - x < kMaxLiteral && runAt(end) < kShortestRun) ++end;
        file += static_cast<char>(end - x);
        for (; x < end; ++x) file += static_cast<char>(line[x][channel]);
    }
}

}  // namespace

std::string encodeHdr(const RgbImage& image) {
    std::string file =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
    constexpr int kMinRunLength = 8, kMaxRunLength = 0x7fff;
    file.reserve(file.size() + image.pixels.size() * sizeof(Rgbe));
    std::vector<Rgbe> line(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) line[static_cast<std::size_t>(x)] = encode(image.at(x, y));
        if (image.width < kMinRunLength || image.width > kMaxRunLength) {
            for (const Rgbe& pixel : line)
                file.append(reinterpret_cast<const char*>(pixel.data()), pixel.size());
            continue;
        }
        for (const int byte : {2, 2, image.width >> 8, image.width & 0xff}) file += static_cast<char>(byte);
        for (std::size_t channel = 0; channel < 4; ++channel) appendChannel(file, line, channel);
    }
    return file;
}

}  // namespace rayscope::image
