#pragma once
#include <rayscope/vector.h>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// The header of a Radiance picture.
struct HdrHeader {
    bool xyz = false;      ///< pixels are CIE XYZ, not RGB
    Rgb factor{1.0f};      ///< by which stored values are multiplied: 1 / (EXPOSURE * COLORCORR)
    bool columns = false;  ///< a scan line is a column
    bool rightToLeft = false, bottomToTop = false;
    int width = 0, height = 0;
    std::size_t pixels = 0;  ///< offset of the first scan line

    int scanLines() const { return columns ? width : height; }
    int scanLineLength() const { return columns ? height : width; }
};

/// Throws InputError; reports what is applied and what is ignored.
HdrHeader readHdrHeader(const ImageFile& file);

}  // namespace rayscope::image
