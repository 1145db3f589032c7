#pragma once
#include <rayscope/vector.h>

#include <array>
#include <cstdint>
#include <vector>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// The bits of a pixel that hold one channel.
struct BitField {
    std::uint32_t mask = 0;

    /// The channel of a pixel, 0 … maximum(); 0 without bits.
    std::uint32_t codeOf(std::uint32_t pixel) const { return mask ? (pixel & mask) / lowestBit() : 0; }
    std::uint32_t maximum() const { return mask ? mask / lowestBit() : 1; }

  private:
    std::uint32_t lowestBit() const { return mask & (~mask + 1u); }
};

/// The headers of a BMP file.
struct BmpHeader {
    enum class Code { Plain, RunLength4, RunLength8, RunLength24 };

    int width = 0, height = 0;
    bool topDown = false;
    int bitsPerPixel = 0;
    Code code = Code::Plain;
    std::array<BitField, 3> fields;  ///< with 16 and 32 bits per pixel
    std::vector<Rgb> palette;        ///< linear, with up to 8 bits per pixel
    std::size_t pixels = 0;          ///< offset of the first row

    std::size_t rowSize() const {  ///< of plain rows, which are padded to 4 bytes
        return (static_cast<std::size_t>(width) * static_cast<std::size_t>(bitsPerPixel) + 31) / 32 * 4;
    }
};

/// Throws InputError; reports what is ignored.
BmpHeader readBmpHeader(const ImageFile& file);

}  // namespace rayscope::image
