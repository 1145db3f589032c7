#pragma once
#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Notes that an embedded ICC profile is ignored, unless it names itself sRGB, which is how pixels are read.
void noteIccProfile(const ImageFile& file, FileBytes profile);

/// Notes that the orientation in EXIF data (from the TIFF header on) is ignored, unless it is upright.
void noteExifOrientation(const ImageFile& file, FileBytes exif);

}  // namespace rayscope::image
