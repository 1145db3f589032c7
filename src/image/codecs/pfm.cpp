// Portable float map: a text header "PF width height scale", then raw floats from the bottom row up. A
// negative scale means little-endian floats. http://www.pauldebevec.com/Research/HDR/PFM/
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "image/codecs/codecs.h"
#include "image/codecs/portable_header.h"

namespace rayscope::image {

namespace {

constexpr bool kIsLittleEndian = std::endian::native == std::endian::little;

float toFloat(const std::byte* bytes, bool swapped) {
    std::byte ordered[sizeof(float)];
    std::memcpy(ordered, bytes, sizeof ordered);
    if (swapped) std::reverse(ordered, ordered + sizeof ordered);
    float value;
    std::memcpy(&value, ordered, sizeof value);
    return value;
}

/// Of the signatures Pf, PF and PF4.
std::size_t channelsOf(std::string_view signature) {
    if (signature == "PF4") return 4;
    return signature == "PF" ? 3 : 1;
}

}  // namespace

RgbImage decodePfm(const ImageFile& file) {
    PortableHeader header(file);
    const std::size_t channels = channelsOf(header.takeWord());
    const long long width = header.takeNumber("width"), height = header.takeNumber("height");
    checkImageSize(width, height, file.bytes.size(), file.name);
    const float scale = header.takeFloat("scale");
    if (!(std::abs(scale) > 0.0f) || !std::isfinite(scale))
        file.damaged(fmt::format("the scale is {}", scale));

    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::byte* bytes = header.takePixels(pixels * channels * sizeof(float)).data();
    RgbImage image(static_cast<int>(width), static_cast<int>(height));
    const bool swapped = (scale < 0.0f) != kIsLittleEndian;
    for (int y = image.height - 1; y >= 0; --y) {
        for (int x = 0; x < image.width; ++x, bytes += channels * sizeof(float)) {
            Rgb value(toFloat(bytes, swapped));
            if (channels >= 3)
                value = Rgb(value.x, toFloat(bytes + sizeof(float), swapped),
                            toFloat(bytes + 2 * sizeof(float), swapped));
            image.at(x, y) = value * std::abs(scale);
        }
    }
    if (std::abs(scale) != 1.0f)
        file.note(fmt::format("the values are multiplied by its scale, {}", std::abs(scale)));
    header.reportRest();
    return image;
}

std::string encodePfm(const RgbImage& image) {
    std::string file =
        fmt::format("PF\n{} {}\n{}\n", image.width, image.height, kIsLittleEndian ? "-1.0" : "1.0");
    file.reserve(file.size() + image.pixels.size() * sizeof(Rgb));
    for (int y = image.height - 1; y >= 0; --y) {
        const Rgb* row = &image.at(0, y);
        file.append(reinterpret_cast<const char*>(row), static_cast<std::size_t>(image.width) * sizeof(Rgb));
    }
    return file;
}

}  // namespace rayscope::image
