#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "image/codecs/codecs.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xff);
    return bytes;
}

/// CRC-32 of ISO 3309, as in Annex D of the PNG specification.
std::uint32_t crc32(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> rows{};
        for (std::uint32_t n = 0; n < rows.size(); ++n) {
            rows[n] = n;
            for (int bit = 0; bit < 8; ++bit) rows[n] = (rows[n] & 1 ? 0xedb88320u : 0u) ^ (rows[n] >> 1);
        }
        return rows;
    }();
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) crc = table[(crc ^ static_cast<std::uint8_t>(byte)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

std::string chunk(std::string_view type, std::string_view data) {
    const std::string body = std::string(type) + std::string(data);
    return bigEndian(static_cast<std::uint32_t>(data.size())) + body + bigEndian(crc32(body));
}

/// A text chunk: tEXt, which all programs read, for ASCII; iTXt for other UTF-8.
std::string textChunk(const std::string& name, const std::string& text) {
    using namespace std::string_literals;
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
    constexpr std::size_t kMaxKeywordLength = 79;
    const std::string keyword = name.substr(0, kMaxKeywordLength);
    if (ascii) return chunk("tEXt", keyword + "\0"s + text);
    const std::string uncompressedWithoutLanguage = "\0\0\0\0\0"s;
    return chunk("iTXt", keyword + uncompressedWithoutLanguage + text);
}

/// Length of the signature and of IHDR, which must be the first chunk.
constexpr std::size_t kHeaderLength = 8 + 4 + 4 + 13 + 4;

}  // namespace

std::string encodePng(const RgbImage& image, const ImageMetadata& metadata, Encoding encoding) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * 3);
    for (const Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) bytes.push_back(encodeByte(pixel[c], encoding));

    std::string file;
    const auto append = [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                                  static_cast<std::size_t>(size));
    };
    stbi_write_png_to_func(append, &file, image.width, image.height, 3, bytes.data(), 3 * image.width);

    std::string extra;
    if (encoding == Encoding::Srgb) extra += chunk("sRGB", std::string_view("\0", 1));
    for (const auto& [key, value] : metadata) extra += textChunk(metadataName(key), value);
    return file.insert(kHeaderLength, extra);
}

}  // namespace rayscope::image
