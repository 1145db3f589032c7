#pragma once
#include "image/codecs/image_file.h"

namespace rayscope::image {

/// What the markers of a JPEG file say.
struct JpegLayout {
    int width = 0, height = 0;
    bool progressive = false;
    bool hasEndMarker = false;
};

/// Checks all markers of a JPEG file before it is decoded. Throws InputError, which names the feature, if the
/// file needs one that is not read, and if it holds no complete image.
JpegLayout checkJpegMarkers(const ImageFile& file);

}  // namespace rayscope::image
