#include "image/codecs/bmp_rle.h"

#include <fmt/format.h>

#include "image/codecs/byte_cursor.h"

namespace rayscope::image {

namespace {

class RunDecoder {
  public:
    RunDecoder(const ImageFile& file, const BmpHeader& header)
        : file_(file),
          code_(header.code),
          width_(static_cast<std::size_t>(header.width)),
          height_(static_cast<std::size_t>(header.height)),
          paddedWidth_(header.rowSize() * 8 / static_cast<std::size_t>(header.bitsPerPixel)),
          cursor_(file, header.pixels),
          pixels_(width_ * height_) {}

    std::vector<std::uint32_t> run() {
        bool going = true;
        // The code of the last row may lack its end.
        while (going && !(y_ >= height_ || (y_ + 1 == height_ && x_ >= width_ && cursor_.left() < 2)))
            going = step();
        report();
        return std::move(pixels_);
    }

  private:
    bool step() {
        const std::uint32_t count = cursor_.takeByte();
        if (count > 0) {
            repeat(count);
            return true;
        }
        switch (const std::uint32_t code = cursor_.takeByte()) {
            case 0:
                x_ = 0;
                ++y_;
                return true;
            case 1:
                return false;
            case 2:
                x_ += cursor_.takeByte();
                y_ += cursor_.takeByte();
                return true;
            default:
                copy(code);
                return true;
        }
    }

    /// A pixel, of RunLength8 and RunLength24.
    std::uint32_t takePixel() {
        if (code_ == BmpHeader::Code::RunLength8) return cursor_.takeByte();
        const FileBytes color = cursor_.take(3);
        return byteAt(color, 2) << 16 | byteAt(color, 1) << 8 | byteAt(color, 0);
    }

    void repeat(std::uint32_t count) {
        if (code_ == BmpHeader::Code::RunLength4) {
            const std::uint32_t both = cursor_.takeByte();
            for (std::uint32_t i = 0; i < count; ++i) put(i % 2 == 0 ? both >> 4 : both & 15);
        } else {
            const std::uint32_t pixel = takePixel();
            for (std::uint32_t i = 0; i < count; ++i) put(pixel);
        }
    }

    /// Literal pixels, padded to an even number of bytes.
    void copy(std::uint32_t count) {
        std::size_t size = count;
        if (code_ == BmpHeader::Code::RunLength4) {
            size = (count + 1) / 2;
            const FileBytes pairs = cursor_.take(size);
            for (std::uint32_t i = 0; i < count; ++i)
                put(i % 2 == 0 ? byteAt(pairs, i / 2) >> 4 : byteAt(pairs, i / 2) & 15);
        } else {
            if (code_ == BmpHeader::Code::RunLength24) size *= 3;
            for (std::uint32_t i = 0; i < count; ++i) put(takePixel());
        }
        if (size % 2 != 0 && cursor_.left() > 0) cursor_.takeByte();
    }

    void put(std::uint32_t pixel) {
        if (x_ < width_ && y_ < height_) {
            pixels_[y_ * width_ + x_] = pixel;
            ++written_;
        } else if (x_ >= paddedWidth_ || y_ >= height_) {
            ++outside_;
        }
        ++x_;
    }

    void report() const {
        if (outside_ > 0)
            file_.warn(fmt::format(
                "its run-length code leaves the image; what lies outside is ignored (pixels: {})", outside_));
        if (written_ < pixels_.size())
            file_.note(fmt::format("what its run-length code skips has the first colour (pixels: {})",
                                   pixels_.size() - written_));
    }

    const ImageFile& file_;
    BmpHeader::Code code_;
    std::size_t width_, height_;
    std::size_t paddedWidth_;  ///< some writers encode the padding of rows
    ByteCursor cursor_;
    std::vector<std::uint32_t> pixels_;
    std::size_t x_ = 0, y_ = 0;
    std::size_t written_ = 0, outside_ = 0;
};

}  // namespace

std::vector<std::uint32_t> decodeBmpRuns(const ImageFile& file, const BmpHeader& header) {
    return RunDecoder(file, header).run();
}

}  // namespace rayscope::image
