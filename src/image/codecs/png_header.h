#pragma once
#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Checks the signature and the size of a PNG file before libpng reads it, and reports what precedes the
/// pixels and is ignored: animation, orientation, a colour space that libpng does not know.
void checkPngHeader(const ImageFile& file);

}  // namespace rayscope::image
