#pragma once
// PNG files from their specification: uncompressed deflate blocks, checksums bit by bit.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/test_images.h"

namespace rayscope::test {

/// CRC-32 bit by bit, as the polynomial division of its definition.
inline std::uint32_t bitwiseCrc(const std::string& bytes) {
    std::uint32_t crc = ~0u;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1u) ? (crc >> 1) ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    return bigEndian(static_cast<std::uint32_t>(data.size()), 4) + type + data +
           bigEndian(bitwiseCrc(type + data), 4);
}

/// A zlib stream of uncompressed blocks.
inline std::string zlibStream(const std::string& data) {
    constexpr std::size_t kMaxBlock = 65535;
    std::string stream("\x78\x01");
    std::uint32_t a = 1, b = 0;
    for (const char byte : data) {
        a = (a + static_cast<std::uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    for (std::size_t at = 0; at == 0 || at < data.size(); at += kMaxBlock) {
        const std::string block = data.substr(at, kMaxBlock);
        const auto length = static_cast<std::uint32_t>(block.size());
        stream += static_cast<char>(at + kMaxBlock >= data.size() ? 1 : 0);
        stream += littleEndian(length, 2) + littleEndian(~length, 2) + block;
    }
    return stream + bigEndian(b << 16 | a, 4);
}

struct PngSpec {
    int width = 1, height = 1, depth = 8, colorType = 2;
    bool interlaced = false;
    std::vector<std::uint32_t> samples{};  ///< of all pixels, row by row
    std::string chunks{};                  ///< between the header and the pixels

    int channels() const { return colorType == 2 ? 3 : colorType == 4 ? 2 : colorType == 6 ? 4 : 1; }
};

/// The rows of one pass: the pixels (x0 + i dx, y0 + j dy).
inline std::string pngRows(const PngSpec& png, int x0, int y0, int dx, int dy) {
    std::string rows;
    for (int y = y0; y < png.height; y += dy) {
        std::string row;
        std::uint32_t pending = 0;
        int bits = 0;
        for (int x = x0; x < png.width; x += dx)
            for (int c = 0; c < png.channels(); ++c) {
                const std::uint32_t sample =
                    png.samples[static_cast<std::size_t>((y * png.width + x) * png.channels() + c)];
                if (png.depth >= 8) {
                    row += bigEndian(sample, png.depth / 8);
                    continue;
                }
                pending = pending << png.depth | sample;
                bits += png.depth;
                if (bits < 8) continue;
                row += static_cast<char>(pending);
                pending = 0;
                bits = 0;
            }
        if (bits > 0) row += static_cast<char>(pending << (8 - bits));
        if (!row.empty()) rows += '\0' + row;  // filter type 0
    }
    return rows;
}

inline std::string pngFile(const PngSpec& png) {
    constexpr std::array<std::array<int, 4>, 7> kAdam7{
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    std::string rows;
    if (png.interlaced)
        for (const auto& [x0, y0, dx, dy] : kAdam7) rows += pngRows(png, x0, y0, dx, dy);
    else
        rows = pngRows(png, 0, 0, 1, 1);
    const std::string header = bigEndian(static_cast<std::uint32_t>(png.width), 4) +
                               bigEndian(static_cast<std::uint32_t>(png.height), 4) +
                               bytesOf({png.depth, png.colorType, 0, 0, png.interlaced ? 1 : 0});
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + png.chunks + pngChunk("IDAT", zlibStream(rows)) +
           pngChunk("IEND", "");
}

}  // namespace rayscope::test
