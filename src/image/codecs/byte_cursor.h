#pragma once
#include <cstdint>

#include "image/codecs/image_file.h"

namespace rayscope::image {

inline std::uint32_t byteAt(FileBytes bytes, std::size_t at) {
    return std::to_integer<std::uint32_t>(bytes[at]);
}

inline std::uint32_t littleEndian16(FileBytes bytes, std::size_t at) {
    return byteAt(bytes, at) | byteAt(bytes, at + 1) << 8;
}
inline std::uint32_t littleEndian32(FileBytes bytes, std::size_t at) {
    return littleEndian16(bytes, at) | littleEndian16(bytes, at + 2) << 16;
}
inline std::uint32_t bigEndian16(FileBytes bytes, std::size_t at) {
    return byteAt(bytes, at) << 8 | byteAt(bytes, at + 1);
}
inline std::uint32_t bigEndian32(FileBytes bytes, std::size_t at) {
    return bigEndian16(bytes, at) << 16 | bigEndian16(bytes, at + 2);
}

/// Takes bytes from the front to the back of a file. Throws InputError (the file is damaged) at its end.
class ByteCursor {
  public:
    explicit ByteCursor(const ImageFile& file, std::size_t position = 0) : file_(file) { seek(position); }

    std::size_t left() const { return file_.bytes.size() - position_; }

    void seek(std::size_t position) {
        if (position > file_.bytes.size()) file_.damaged(kEndsTooEarly);
        position_ = position;
    }
    FileBytes take(std::size_t count) {
        if (count > left()) file_.damaged(kEndsTooEarly);
        const FileBytes taken = file_.bytes.subspan(position_, count);
        position_ += count;
        return taken;
    }
    std::uint32_t takeByte() { return byteAt(take(1), 0); }

  private:
    const ImageFile& file_;
    std::size_t position_ = 0;
};

}  // namespace rayscope::image
