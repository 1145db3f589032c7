// Portable float map: a text header "PF width height scale", then raw floats from the bottom row up. A
// negative scale means little-endian floats. http://www.pauldebevec.com/Research/HDR/PFM/
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "image/codecs/codecs.h"

namespace rayscope::image {

namespace {

constexpr bool kIsLittleEndian = std::endian::native == std::endian::little;

/// Removes the next token of the header from the front of `text`.
std::string_view takeToken(std::string_view& text) {
    constexpr std::string_view kSpaces = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    const std::string_view token = text.substr(0, text.find_first_of(kSpaces));
    text.remove_prefix(token.size());
    return token;
}

template <class Number>
Number takeNumber(std::string_view& text, const std::string& name, const char* what) {
    const std::string_view token = takeToken(text);
    Number number{};
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
    if (error != std::errc{} || end != token.data() + token.size())
        throwDamaged(name, fmt::format("no valid {} in the header", what));
    return number;
}

float toFloat(const char* bytes, bool swapped) {
    char ordered[sizeof(float)];
    std::memcpy(ordered, bytes, sizeof ordered);
    if (swapped) std::reverse(ordered, ordered + sizeof ordered);
    float value;
    std::memcpy(&value, ordered, sizeof value);
    return value;
}

}  // namespace

bool looksLikePfm(FileBytes file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    return text.size() > 2 && (text.starts_with("PF") || text.starts_with("Pf")) &&
           std::string_view(" \t\r\n").find(text[2]) != std::string_view::npos;
}

RgbImage decodePfm(FileBytes file, const std::string& name) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const std::size_t channels = takeToken(text) == "PF" ? 3 : 1;
    const int width = takeNumber<int>(text, name, "width");
    const int height = takeNumber<int>(text, name, "height");
    checkImageSize(width, height, file.size(), name);
    const float scale = takeNumber<float>(text, name, "scale");
    if (!(std::abs(scale) > 0.0f)) throwDamaged(name, "the scale is 0");
    if (!text.empty()) text.remove_prefix(1);  // exactly one white-space character ends the header

    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (text.size() < pixels * channels * sizeof(float)) throwDamaged(name, "unexpected end of file");
    RgbImage image(width, height);
    const bool swapped = (scale < 0.0f) != kIsLittleEndian;
    const char* bytes = text.data();
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            Rgb value(toFloat(bytes, swapped));
            if (channels == 3)
                value = Rgb(value.x, toFloat(bytes + sizeof(float), swapped),
                            toFloat(bytes + 2 * sizeof(float), swapped));
            image.at(x, y) = value * std::abs(scale);
            bytes += channels * sizeof(float);
        }
    }
    return image;
}

std::string encodePfm(const RgbImage& image) {
    std::string file =
        fmt::format("PF\n{} {}\n{}\n", image.width, image.height, kIsLittleEndian ? "-1.0" : "1.0");
    for (int y = image.height - 1; y >= 0; --y) {
        const Rgb* row = &image.at(0, y);
        file.append(reinterpret_cast<const char*>(row), static_cast<std::size_t>(image.width) * sizeof(Rgb));
    }
    return file;
}

}  // namespace rayscope::image
