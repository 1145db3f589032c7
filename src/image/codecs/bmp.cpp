// Bitmaps of OS/2 1 and 2 and of Windows 3 to 5.
// https://learn.microsoft.com/en-us/windows/win32/gdi/bitmap-storage
#include <fmt/format.h>

#include <array>
#include <vector>

#include "image/codecs/bmp_header.h"
#include "image/codecs/bmp_rle.h"
#include "image/codecs/byte_cursor.h"
#include "image/codecs/codecs.h"
#include "image/codecs/palette_lookup.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

Rgb decodeColor(std::uint32_t rgb) {
    const auto channel = [&](int shift) { return decodeByte(static_cast<std::uint8_t>(rgb >> shift)); };
    return Rgb(channel(16), channel(8), channel(0));
}

/// The pixels of rows without run-length code.
class PlainRows {
  public:
    PlainRows(const BmpHeader& header, PaletteLookup& palette) : header_(header), palette_(palette) {
        constexpr std::uint32_t kMaxTable = 0xffff;
        for (std::size_t i = 0; i < 3; ++i)
            if (header.fields[i].maximum() <= kMaxTable) linear_[i] = srgbTable(header.fields[i].maximum());
    }

    Rgb pixelAt(FileBytes row, int x) {
        const auto at = static_cast<std::size_t>(x);
        const auto bits = static_cast<std::size_t>(header_.bitsPerPixel);
        if (bits == 16) return unpack(littleEndian16(row, 2 * at));
        if (bits == 32) return unpack(littleEndian32(row, 4 * at));
        if (bits == 24) return decodeColor(littleEndian16(row, 3 * at) | byteAt(row, 3 * at + 2) << 16);
        const std::size_t first = at * bits,
                          shift = 8 - bits - first % 8;  // the leftmost pixel is in the highest bits
        return palette_.colorOf(byteAt(row, first / 8) >> shift & ((1u << bits) - 1));
    }

  private:
    Rgb unpack(std::uint32_t pixel) const {
        const auto channel = [&](std::size_t i) {
            const std::uint32_t code = header_.fields[i].codeOf(pixel);
            if (!linear_[i].empty()) return linear_[i][code];
            return srgbToLinear(static_cast<float>(code) / static_cast<float>(header_.fields[i].maximum()));
        };
        return Rgb(channel(0), channel(1), channel(2));
    }

    std::array<std::vector<float>, 3> linear_;  ///< of the codes of each field, unless there are too many
    const BmpHeader& header_;
    PaletteLookup& palette_;
};

int imageRow(const BmpHeader& header, int row) { return header.topDown ? row : header.height - 1 - row; }

void checkLength(const ImageFile& file, const BmpHeader& header) {
    const std::size_t rows = static_cast<std::size_t>(header.height);
    const std::size_t lastRow =
        (static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.bitsPerPixel) + 7) / 8;
    const std::size_t needed = (rows - 1) * header.rowSize() + lastRow;
    const std::size_t present = file.bytes.size() - header.pixels;
    if (present < needed) file.damaged(fmt::format("{} bytes of pixels instead of {}", present, needed));
}

}  // namespace

RgbImage decodeBmp(const ImageFile& file) {
    const BmpHeader header = readBmpHeader(file);
    PaletteLookup palette(header.palette);
    if (header.code != BmpHeader::Code::Plain) {
        const std::vector<std::uint32_t> pixels = decodeBmpRuns(file, header);
        RgbImage image(header.width, header.height);
        std::size_t next = 0;
        for (int row = 0; row < header.height; ++row)
            for (int x = 0; x < header.width; ++x, ++next)
                image.at(x, imageRow(header, row)) = header.code == BmpHeader::Code::RunLength24
                                                         ? decodeColor(pixels[next])
                                                         : palette.colorOf(pixels[next]);
        palette.report(file);
        return image;
    }
    checkLength(file, header);
    RgbImage image(header.width, header.height);
    PlainRows rows(header, palette);
    for (int row = 0; row < header.height; ++row) {
        const std::size_t start = header.pixels + static_cast<std::size_t>(row) * header.rowSize();
        const FileBytes bytes = file.bytes.subspan(start);
        for (int x = 0; x < header.width; ++x) image.at(x, imageRow(header, row)) = rows.pixelAt(bytes, x);
    }
    palette.report(file);
    return image;
}

}  // namespace rayscope::image
