#pragma once
#include <vector>

#include "image/codecs/bmp_header.h"

namespace rayscope::image {

/// Decodes the run-length code of a BMP file. Returns the pixels from the lower left corner on: indices, or
/// red * 65536 + green * 256 + blue with 24 bits. Pixels that the code skips are 0.
std::vector<std::uint32_t> decodeBmpRuns(const ImageFile& file, const BmpHeader& header);

}  // namespace rayscope::image
