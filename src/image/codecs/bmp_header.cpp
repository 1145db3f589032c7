#include "image/codecs/bmp_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "image/codecs/byte_cursor.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

constexpr std::size_t kFileHeader = 14, kOs2Header = 12, kInfoHeader = 40, kV4Header = 108, kV5Header = 124;

enum BmpCompression : std::uint32_t {
    kNone,
    kRunLength8,
    kRunLength4,
    kBitFields,
    kJpeg,
    kPng,
    kAlphaBitFields
};

class BmpHeaderReader {
  public:
    explicit BmpHeaderReader(const ImageFile& file) : file_(file), bytes_(file.bytes) {}

    BmpHeader read() {
        if (bytes_.size() < kFileHeader + kOs2Header) file_.damaged(kEndsTooEarly);
        size_ = littleEndian32(bytes_, kFileHeader);
        // OS/2 2.x headers may be cut behind any field.
        const bool known =
            size_ == kOs2Header || (size_ >= 16 && size_ <= 64) || size_ == kV4Header || size_ == kV5Header;
        if (!known) file_.damaged(fmt::format("its header has {} bytes", size_));
        if (bytes_.size() < kFileHeader + size_) file_.damaged(kEndsTooEarly);
        readSize();
        readCode();
        end_ = kFileHeader + size_;
        if (header_.bitsPerPixel == 16 || header_.bitsPerPixel == 32) readFields();
        findPixels();
        if (header_.bitsPerPixel <= 8) readPalette();
        if (size_ >= kV4Header) reportColorSpace();
        return header_;
    }

  private:
    /// A field of 4 bytes of the header; 0 if the header is too short for it.
    std::uint32_t field(std::size_t offset) const {
        return offset + 4 <= size_ ? littleEndian32(bytes_, kFileHeader + offset) : 0;
    }

    void readSize() {
        const bool oldest = size_ == kOs2Header;
        long long height;
        if (oldest) {
            header_.width = static_cast<int>(littleEndian16(bytes_, kFileHeader + 4));
            height = littleEndian16(bytes_, kFileHeader + 6);
            header_.bitsPerPixel = static_cast<int>(littleEndian16(bytes_, kFileHeader + 10));
        } else {
            header_.width = static_cast<std::int32_t>(field(4));
            height = static_cast<std::int32_t>(field(8));
            header_.bitsPerPixel = static_cast<int>(littleEndian16(bytes_, kFileHeader + 14));
        }
        header_.topDown = height < 0;
        height = std::abs(height);
        checkImageSize(header_.width, height, bytes_.size(), file_.name);
        header_.height = static_cast<int>(height);
    }

    void readCode() {
        compression_ = field(16);
        const int bits = header_.bitsPerPixel;
        const auto expectBits = [&](int expected) {
            if (bits != expected)
                file_.damaged(
                    fmt::format("run-length code for {} bits per pixel, but it has {}", expected, bits));
        };
        // OS/2 gives 3 and 4 other meanings, each with its own number of bits.
        if (compression_ == kBitFields && bits == 1)
            file_.refuse("is a BMP image with Huffman code, which is not read; convert it to PNG");
        const bool runs24 = compression_ == kJpeg && bits == 24;
        if (!runs24 && (compression_ == kJpeg || compression_ == kPng))
            file_.refuse(
                fmt::format("is a BMP image that contains a {0} image, which is not read; save the {0} image",
                            compression_ == kJpeg ? "JPEG" : "PNG"));
        if (compression_ == kRunLength4) {
            header_.code = BmpHeader::Code::RunLength4;
            expectBits(4);
        } else if (compression_ == kRunLength8) {
            header_.code = BmpHeader::Code::RunLength8;
            expectBits(8);
        } else if (runs24) {
            header_.code = BmpHeader::Code::RunLength24;
        } else if (compression_ >= 11 && compression_ <= 13) {
            file_.refuse("is a BMP image in CMYK, which is not read; convert it to PNG");
        } else if (compression_ != kNone && compression_ != kBitFields && compression_ != kAlphaBitFields) {
            file_.damaged(fmt::format("its compression is {}", compression_));
        }
        const bool hasMasks = size_ == kInfoHeader || size_ == 52 || size_ == 56 || size_ >= kV4Header;
        if (hasBitFields() && (!hasMasks || (bits != 16 && bits != 32)))
            file_.damaged(
                fmt::format("bit fields with {} bits per pixel and a header of {} bytes", bits, size_));
        constexpr int kBits[]{1, 2, 4, 8, 16, 24, 32};
        if (bits == 64)
            file_.refuse(
                "is a BMP image with 64 bits per pixel, which are not read; convert it to PNG or EXR");
        if (std::find(std::begin(kBits), std::end(kBits), bits) == std::end(kBits))
            file_.damaged(fmt::format("it has {} bits per pixel", bits));
    }

    bool hasBitFields() const { return compression_ == kBitFields || compression_ == kAlphaBitFields; }

    /// The masks of the channels: in the header, or behind the oldest header with bit fields.
    void readFields() {
        const bool wide = header_.bitsPerPixel == 32;
        header_.fields = {{{wide ? 0xff0000u : 0x7c00u}, {wide ? 0xff00u : 0x3e0u}, {wide ? 0xffu : 0x1fu}}};
        if (!hasBitFields()) return;
        if (size_ == kInfoHeader) {
            end_ += compression_ == kAlphaBitFields ? 16 : 12;
            if (bytes_.size() < end_) file_.damaged(kEndsTooEarly);
        }
        std::uint32_t all = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t mask = littleEndian32(bytes_, kFileHeader + kInfoHeader + 4 * i);
            const std::uint32_t shifted = mask ? mask >> std::countr_zero(mask) : 0;
            if ((shifted & (shifted + 1)) != 0 || (all & mask) != 0 || (!wide && mask > 0xffff))
                file_.damaged(fmt::format("the bit mask of a channel is {:#010x}", mask));
            header_.fields[i].mask = mask;
            all |= mask;
        }
        if (all == 0) file_.damaged("the bit masks of all channels are 0");
    }

    /// The pixels start where the file header says, if there is room for the headers and a palette before.
    void findPixels() {
        std::size_t offset = littleEndian32(bytes_, 10);
        const bool indexed = header_.bitsPerPixel <= 8;
        const std::size_t expected = end_ + (indexed ? announcedColors() * paletteEntrySize() : 0);
        if (offset < end_ + (indexed ? paletteEntrySize() : 0) || offset > bytes_.size()) {
            file_.warn(fmt::format("the offset of the pixels, {}, is wrong; they are read from byte {}",
                                   offset, expected));
            offset = expected;
        }
        if (offset > bytes_.size()) file_.damaged(kEndsTooEarly);
        header_.pixels = offset;
    }

    std::size_t paletteEntrySize() const { return size_ == kOs2Header ? 3 : 4; }

    std::size_t announcedColors() const {
        const std::uint32_t used = field(32);
        return used > 0 ? used : std::size_t{1} << header_.bitsPerPixel;
    }

    void readPalette() {
        const std::size_t entry = paletteEntrySize();
        const std::size_t room = (header_.pixels - end_) / entry;
        const std::size_t usable = std::size_t{1} << header_.bitsPerPixel;
        const std::size_t count = std::min({announcedColors(), room, usable});
        for (std::size_t i = 0; i < count; ++i) {
            const FileBytes color = bytes_.subspan(end_ + i * entry, 3);  // blue, green, red
            const auto channel = [&](std::size_t c) {
                return decodeByte(std::to_integer<std::uint8_t>(color[c]));
            };
            header_.palette.push_back(Rgb(channel(2), channel(1), channel(0)));
        }
    }

    void reportColorSpace() const {
        constexpr std::uint32_t kCalibrated = 0, kLinked = 0x4c494e4b, kEmbedded = 0x4d424544;
        constexpr std::size_t kColorSpace = 56, kGammaRed = 96;
        const std::uint32_t space = field(kColorSpace);
        if (space == kLinked || space == kEmbedded)
            file_.note("the ICC profile is ignored: the colours are read as sRGB");
        if (space == kCalibrated && field(kGammaRed) != 0)
            file_.note("the gamma and the primaries of the image are ignored: the colours are read as sRGB");
    }

    const ImageFile& file_;
    FileBytes bytes_;
    std::size_t size_ = 0, end_ = 0;
    std::uint32_t compression_ = 0;
    BmpHeader header_;
};

}  // namespace

BmpHeader readBmpHeader(const ImageFile& file) { return BmpHeaderReader(file).read(); }

}  // namespace rayscope::image
