// Truevision TGA 1 and 2. https://www.dca.fee.unicamp.br/~martino/disciplinas/ia369/trabalhos/tga.pdf
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "image/codecs/byte_cursor.h"
#include "image/codecs/codecs.h"
#include "image/codecs/palette_lookup.h"
#include "image/srgb.h"

namespace rayscope::image {

namespace {

constexpr std::size_t kHeaderSize = 18;

enum Kind : std::uint32_t { kIndexed = 1, kColor = 2, kGrey = 3 };

struct Header {
    std::uint32_t idLength, mapType, kind, firstColor, colors, colorBits, width, height, pixelBits;
    bool runs, rightToLeft, topDown;
    std::uint32_t attributeBits, interleaving;

    std::size_t colorSize() const { return (colorBits + 7) / 8; }
    std::size_t pixelSize() const { return (pixelBits + 7) / 8; }
    std::size_t mapSize() const { return mapType == 1 ? colors * colorSize() : 0; }
};

Header headerOf(FileBytes file) {
    const std::uint32_t type = byteAt(file, 2), descriptor = byteAt(file, 17);
    return {.idLength = byteAt(file, 0),
            .mapType = byteAt(file, 1),
            .kind = type & ~8u,
            .firstColor = littleEndian16(file, 3),
            .colors = littleEndian16(file, 5),
            .colorBits = byteAt(file, 7),
            .width = littleEndian16(file, 12),
            .height = littleEndian16(file, 14),
            .pixelBits = byteAt(file, 16),
            .runs = (type & 8u) != 0,
            .rightToLeft = (descriptor & 16u) != 0,
            .topDown = (descriptor & 32u) != 0,
            .attributeBits = descriptor & 15u,
            .interleaving = descriptor >> 6};
}

bool isOneOf(std::uint32_t value, std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t v : values)
        if (v == value) return true;
    return false;
}

/// The pixels from the first to the last in the file, without run-length code.
class PixelReader {
  public:
    PixelReader(const ImageFile& file, const Header& header)
        : header_(header), cursor_(file, kHeaderSize + header.idLength) {
        const FileBytes map = cursor_.take(header.mapSize());
        for (std::size_t at = 0; header.kind == kIndexed && at < map.size(); at += header.colorSize())
            map_.push_back(colorOf(map.subspan(at), header.colorBits));
    }

    Rgb next() {
        if (!header_.runs) return convert(cursor_.take(header_.pixelSize()));
        if (left_ == 0) {
            const std::uint32_t packet = cursor_.takeByte();
            left_ = (packet & 127u) + 1;
            repeated_ = packet >= 128;
            if (repeated_) color_ = convert(cursor_.take(header_.pixelSize()));
        }
        --left_;
        return repeated_ ? color_ : convert(cursor_.take(header_.pixelSize()));
    }

    void report(const ImageFile& file) const { lookup_.report(file); }

  private:
    Rgb convert(FileBytes pixel) {
        if (header_.kind == kColor) return colorOf(pixel, header_.pixelBits);
        if (header_.kind == kGrey) return Rgb(decodeByte(static_cast<std::uint8_t>(byteAt(pixel, 0))));
        const std::size_t index = header_.pixelBits == 8 ? byteAt(pixel, 0) : littleEndian16(pixel, 0);
        return lookup_.colorOf(index);
    }

    Rgb colorOf(FileBytes bytes, std::uint32_t bits) const {
        if (bits <= 16) {
            const std::uint32_t packed = littleEndian16(bytes, 0);
            return Rgb(fiveBits_[packed >> 10 & 31], fiveBits_[packed >> 5 & 31], fiveBits_[packed & 31]);
        }
        const auto channel = [&](std::size_t i) {
            return decodeByte(static_cast<std::uint8_t>(byteAt(bytes, i)));
        };
        return Rgb(channel(2), channel(1), channel(0));
    }

    const Header& header_;
    ByteCursor cursor_;
    std::vector<float> fiveBits_ = srgbTable(31);
    std::vector<Rgb> map_;
    PaletteLookup lookup_{map_, header_.firstColor};
    std::uint32_t left_ = 0;
    bool repeated_ = false;
    Rgb color_{0.0f};
};

/// Throws InputError if the file cannot hold the pixels: a run of 128 pixels needs a byte and one pixel.
void checkLength(const ImageFile& file, const Header& header) {
    const std::size_t pixels = std::size_t{header.width} * header.height;
    const std::size_t bytes =
        header.runs ? pixels / 128 * (1 + header.pixelSize()) : pixels * header.pixelSize();
    if (file.bytes.size() - kHeaderSize < bytes) file.damaged(kEndsTooEarly);
}

void reportGamma(const ImageFile& file) {
    constexpr std::size_t kFooterSize = 26, kExtensionSize = 495, kGammaOffset = 478;
    const FileBytes bytes = file.bytes;
    if (bytes.size() < kFooterSize + kExtensionSize) return;
    const FileBytes footer = bytes.last(kFooterSize);
    const std::string_view text(reinterpret_cast<const char*>(footer.data()), footer.size());
    if (!text.substr(8).starts_with("TRUEVISION-XFILE.")) return;
    const std::size_t extension = littleEndian32(footer, 0);
    if (extension == 0 || extension > bytes.size() - kExtensionSize) return;
    const std::uint32_t numerator = littleEndian16(bytes, extension + kGammaOffset);
    const std::uint32_t denominator = littleEndian16(bytes, extension + kGammaOffset + 2);
    if (denominator != 0 && numerator != 0)
        file.note(fmt::format("the gamma of the image, {:.3g}, is ignored: the colours are read as sRGB",
                              static_cast<double>(numerator) / denominator));
}

}  // namespace

std::string tgaProblem(FileBytes file) {
    if (file.size() < kHeaderSize) return kEndsTooEarly;
    const Header header = headerOf(file);
    if (header.mapType > 1) return fmt::format("its colour map has type {}", header.mapType);
    if (!isOneOf(header.kind, {kIndexed, kColor, kGrey}))
        return fmt::format("its type is {}", byteAt(file, 2));
    if (header.mapType == 1 && !isOneOf(header.colorBits, {15, 16, 24, 32}))
        return fmt::format("its colour map has {} bits per colour", header.colorBits);
    if (header.kind == kIndexed && (header.mapType == 0 || header.colors == 0)) return "it has no colour map";
    const bool depthFits = header.kind == kColor ? isOneOf(header.pixelBits, {15, 16, 24, 32})
                                                 : isOneOf(header.pixelBits, {8, 16});
    if (!depthFits) return fmt::format("it has {} bits per pixel", header.pixelBits);
    if (header.attributeBits > 8)
        return fmt::format("it has {} attribute bits per pixel", header.attributeBits);
    if (header.width == 0 || header.height == 0)
        return fmt::format("its size is {} x {} pixels", header.width, header.height);
    return {};
}

RgbImage decodeTga(const ImageFile& file) {
    const Header header = headerOf(file.bytes);
    if (header.interleaving != 0)
        file.refuse("is a TGA image with interleaved rows, which are not read; save it again");
    checkImageSize(header.width, header.height, file.bytes.size(), file.name);
    checkLength(file, header);
    PixelReader pixels(file, header);
    const int width = static_cast<int>(header.width), height = static_cast<int>(header.height);
    RgbImage image(width, height);
    for (int row = 0; row < height; ++row) {
        Rgb* const pixel = &image.at(0, header.topDown ? row : height - 1 - row);
        for (int x = 0; x < width; ++x) pixel[header.rightToLeft ? width - 1 - x : x] = pixels.next();
    }
    pixels.report(file);
    reportGamma(file);
    return image;
}

}  // namespace rayscope::image
