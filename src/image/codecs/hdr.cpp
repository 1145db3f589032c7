// Radiance pictures: an ASCII header, then scan lines of pixels with three mantissas and a common exponent.
// https://radsite.lbl.gov/radiance/refer/filefmts.pdf
#include <array>
#include <cmath>
#include <vector>

#include "image/codecs/byte_cursor.h"
#include "image/codecs/codecs.h"
#include "image/codecs/hdr_header.h"

namespace rayscope::image {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Decodes one scan line after the other. Each may be flat, or in the older or newer run-length code.
class ScanLines {
  public:
    ScanLines(const ImageFile& file, const HdrHeader& header)
        : file_(file),
          cursor_(file, header.pixels),
          line_(static_cast<std::size_t>(header.scanLineLength())) {}

    const std::vector<Rgbe>& next() {
        constexpr std::size_t kMinRunLength = 8, kMaxRunLength = 0x7fff;
        const Rgbe first = takePixel();
        const bool marked = first[0] == 2 && first[1] == 2 && first[2] < 128;
        if (!marked || line_.size() < kMinRunLength || line_.size() > kMaxRunLength) {
            readPixels(first);
        } else {
            if ((std::size_t{first[2]} << 8 | first[3]) != line_.size())
                file_.damaged("a scan line has another length than the image");
            for (std::size_t channel = 0; channel < 4; ++channel) readChannel(channel);
        }
        return line_;
    }

  private:
    Rgbe takePixel() {
        const FileBytes bytes = cursor_.take(4);
        Rgbe pixel;
        for (std::size_t i = 0; i < 4; ++i) pixel[i] = std::to_integer<std::uint8_t>(bytes[i]);
        return pixel;
    }

    /// Pixels one after the other. A pixel (1, 1, 1, n) repeats the previous one n times; a second one
    /// directly behind it 256 n times.
    void readPixels(Rgbe pixel) {
        std::size_t count = 0;
        for (int shift = 0;; pixel = takePixel()) {
            if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
                constexpr int kMaxShift = 24;
                const std::size_t repeats = shift > kMaxShift ? line_.size() : std::size_t{pixel[3]} << shift;
                if (count == 0 || repeats > line_.size() - count) file_.damaged("a run leaves its scan line");
                std::fill_n(line_.begin() + static_cast<std::ptrdiff_t>(count), repeats, line_[count - 1]);
                count += repeats;
                shift += 8;
            } else {
                line_[count++] = pixel;
                shift = 0;
            }
            if (count == line_.size()) return;
        }
    }

    /// One channel of all pixels: runs with codes above 128, and literal bytes.
    void readChannel(std::size_t channel) {
        for (std::size_t x = 0; x < line_.size();) {
            const std::uint32_t code = cursor_.takeByte();
            const std::size_t count = code > 128 ? code - 128 : code;
            if (count == 0 || count > line_.size() - x) file_.damaged("a run leaves its scan line");
            const FileBytes values = cursor_.take(code > 128 ? 1 : count);
            for (std::size_t i = 0; i < count; ++i)
                line_[x++][channel] = std::to_integer<std::uint8_t>(values[code > 128 ? 0 : i]);
        }
    }

    const ImageFile& file_;
    ByteCursor cursor_;
    std::vector<Rgbe> line_;
};

/// The matrix of IEC 61966-2-1 from CIE XYZ to linear sRGB.
Rgb rgbOfXyz(const Rgb& xyz) {
    const Rgb rgb(3.2406f * xyz.x - 1.5372f * xyz.y - 0.4986f * xyz.z,
                  -0.9689f * xyz.x + 1.8758f * xyz.y + 0.0415f * xyz.z,
                  0.0557f * xyz.x - 0.2040f * xyz.y + 1.0570f * xyz.z);
    return Rgb(std::max(rgb.x, 0.0f), std::max(rgb.y, 0.0f), std::max(rgb.z, 0.0f));
}

Rgb decode(const Rgbe& pixel, const HdrHeader& header) {
    if (pixel[3] == 0) return Rgb(0.0f);
    constexpr int kBias = 128 + 8;  // the mantissa is 0 … 255
    const float unit = std::ldexp(1.0f, pixel[3] - kBias);
    const Rgb stored(static_cast<float>(pixel[0]) * unit, static_cast<float>(pixel[1]) * unit,
                     static_cast<float>(pixel[2]) * unit);
    const Rgb value = stored * header.factor;
    return header.xyz ? rgbOfXyz(value) : value;
}

}  // namespace

RgbImage decodeHdr(const ImageFile& file) {
    const HdrHeader header = readHdrHeader(file);
    ScanLines lines(file, header);
    RgbImage image(header.width, header.height);
    for (int i = 0; i < header.scanLines(); ++i) {
        int k = 0;
        for (const Rgbe& pixel : lines.next()) {
            const int column = header.columns ? i : k, row = header.columns ? k : i;
            image.at(header.rightToLeft ? header.width - 1 - column : column,
                     header.bottomToTop ? header.height - 1 - row : row) = decode(pixel, header);
            ++k;
        }
    }
    return image;
}

}  // namespace rayscope::image
