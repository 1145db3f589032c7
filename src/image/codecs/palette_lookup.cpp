#include "image/codecs/palette_lookup.h"

#include <fmt/format.h>

namespace rayscope::image {

void PaletteLookup::report(const ImageFile& file) const {
    if (invalid_ > 0)
        file.warn(fmt::format(
            "pixels with indices beyond the palette are black (pixels: {}, first index: {}, colours: {})",
            invalid_, firstInvalid_, palette_.size()));
}

}  // namespace rayscope::image
