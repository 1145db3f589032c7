#pragma once
// The text at the start of portable pixmaps, graymaps, bitmaps and float maps.
#include <string_view>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Words separated by white space and by remarks, which reach from '#' to the end of the line.
class PortableHeader {
  public:
    explicit PortableHeader(const ImageFile& file)
        : file_(file), text_(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()) {}

    /// The next word; empty at the end of the file.
    std::string_view takeWord();

    /// The next word as a number. Throws InputError, which names `what`, if it is none.
    long long takeNumber(const char* what);
    float takeFloat(const char* what);

    /// The next word as the sample of a pixel.
    long long takeSample();

    /// The next of the digits '0' and '1', which need no space between them.
    bool takeBit();

    /// The bytes behind the header, which ends with a single white-space character, or with a remark and the
    /// end of its line. CR LF counts as one character if `needed` bytes follow it.
    FileBytes takePixels(std::size_t needed);

    /// Warns about what follows the pixels, if it is not white space.
    void reportRest() const;

  private:
    void skipSpaces();

    const ImageFile& file_;
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace rayscope::image
