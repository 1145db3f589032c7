// The formats of Netpbm: PBM, PGM and PPM as text (P1 to P3) and binary (P4 to P6), and PAM (P7).
// https://netpbm.sourceforge.net/doc/pnm.html
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "image/codecs/byte_cursor.h"
#include "image/codecs/codecs.h"
#include "image/codecs/portable_header.h"
#include "image/srgb.h"
#include "math/vectors.h"

namespace rayscope::image {

namespace {

constexpr long long kMaxSample = 65535;

struct Layout {
    long long width = 0, height = 0, depth = 1, maximum = 1;
    bool bits = false, text = false;  ///< bits: PBM, in which 1 is black
};

Layout takePnmHeader(PortableHeader& header, char kind) {
    Layout layout{.bits = kind == '1' || kind == '4', .text = kind <= '3'};
    if (kind == '3' || kind == '6') layout.depth = 3;
    layout.width = header.takeNumber("width");
    layout.height = header.takeNumber("height");
    if (!layout.bits) layout.maximum = header.takeNumber("maximum");
    return layout;
}

/// The types that the specification defines; the depth says which one it is. Others would be read as wrong
/// colours.
void checkTupleType(const ImageFile& file, std::string_view type) {
    for (const std::string_view known : {"BLACKANDWHITE", "GRAYSCALE", "RGB"})
        if (type == known || (type.starts_with(known) && type.substr(known.size()) == "_ALPHA")) return;
    file.refuse(fmt::format("is a PAM image of the type {}, which is not read; convert it to PPM", type));
}

Layout takePamHeader(const ImageFile& file, PortableHeader& header) {
    Layout layout{.depth = 0, .maximum = 0};
    for (;;) {
        const std::string_view key = header.takeWord();
        if (key == "ENDHDR") return layout;
        if (key == "WIDTH")
            layout.width = header.takeNumber("WIDTH");
        else if (key == "HEIGHT")
            layout.height = header.takeNumber("HEIGHT");
        else if (key == "DEPTH")
            layout.depth = header.takeNumber("DEPTH");
        else if (key == "MAXVAL")
            layout.maximum = header.takeNumber("MAXVAL");
        else if (key == "TUPLTYPE")
            checkTupleType(file, header.takeWord());
        else
            file.damaged("the header lacks ENDHDR");
    }
}

void check(const ImageFile& file, const Layout& layout) {
    checkImageSize(layout.width, layout.height, file.bytes.size(), file.name);
    if (layout.maximum < 1 || layout.maximum > kMaxSample)
        file.damaged(fmt::format("the maximum is {}, expected 1 to {}", layout.maximum, kMaxSample));
    if (layout.depth < 1 || layout.depth > 4)
        file.refuse(
            fmt::format("is a PAM image with {} channels, of which only 1 to 4 are read; convert it to PPM",
                        layout.depth));
}

/// The samples of the rows, one row after the other.
class SampleReader {
  public:
    SampleReader(const ImageFile& file, PortableHeader& header, const Layout& layout)
        : file_(file),
          header_(header),
          layout_(layout),
          row_(static_cast<std::size_t>(layout.width * layout.depth)) {
        const std::size_t rows = static_cast<std::size_t>(layout.height);
        if (!layout.text)
            bytes_ = header.takePixels(rowSize() * rows);
        else if (file.bytes.size() / rows < row_.size())  // a sample has one character at least
            file.damaged(kEndsTooEarly);
    }

    const std::vector<std::uint32_t>& next() {
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = sample(i);
        if (!layout_.text) bytes_ = bytes_.subspan(rowSize());
        return row_;
    }

  private:
    bool wide() const { return layout_.maximum > 255; }
    std::size_t rowSize() const {
        return layout_.bits ? (row_.size() + 7) / 8 : row_.size() * (wide() ? 2 : 1);
    }

    std::uint32_t sample(std::size_t i) {
        if (layout_.bits) {
            const bool black =
                layout_.text ? header_.takeBit() : (byteAt(bytes_, i / 8) >> (7 - i % 8) & 1) != 0;
            return black ? 0 : 1;
        }
        const long long value = layout_.text ? header_.takeSample()
                                : wide()     ? bigEndian16(bytes_, 2 * i)
                                             : byteAt(bytes_, i);
        if (value < 0 || value > layout_.maximum)
            file_.damaged(fmt::format("a pixel has the value {}, the maximum is {}", value, layout_.maximum));
        return static_cast<std::uint32_t>(value);
    }

    const ImageFile& file_;
    PortableHeader& header_;
    const Layout& layout_;
    std::vector<std::uint32_t> row_;
    FileBytes bytes_;
};

}  // namespace

RgbImage decodePnm(const ImageFile& file) {
    PortableHeader header(file);
    const char kind = header.takeWord()[1];
    const Layout layout = kind == '7' ? takePamHeader(file, header) : takePnmHeader(header, kind);
    check(file, layout);
    SampleReader samples(file, header, layout);
    const std::vector<float> linear = srgbTable(static_cast<std::uint32_t>(layout.maximum));
    RgbImage image(static_cast<int>(layout.width), static_cast<int>(layout.height));
    const auto depth = static_cast<std::size_t>(layout.depth);
    for (int y = 0; y < image.height; ++y) {
        const std::vector<std::uint32_t>& row = samples.next();
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t* pixel = &row[static_cast<std::size_t>(x) * depth];
            image.at(x, y) =
                depth < 3 ? Rgb(linear[pixel[0]]) : Rgb(linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]);
        }
    }
    header.reportRest();
    return image;
}

std::string encodePpm(const RgbImage& image, Encoding encoding) {
    std::string file = fmt::format("P6\n{} {}\n255\n", image.width, image.height);
    std::size_t at = file.size();
    file.resize(at + 3 * image.pixels.size());
    for (const Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) file[at++] = static_cast<char>(encodeByte(pixel[c], encoding));
    return file;
}

std::string encodePgm(const RgbImage& image, Encoding encoding) {
    std::string file = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
    file.reserve(file.size() + image.pixels.size());
    for (const Rgb& pixel : image.pixels)
        file += static_cast<char>(encodeByte(math::luminance(pixel), encoding));
    return file;
}

}  // namespace rayscope::image
