#pragma once
#include <rayscope/image.h>

#include <vector>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Looks up colours of a palette and counts the indices beyond it, which are black.
class PaletteLookup {
  public:
    explicit PaletteLookup(const std::vector<Rgb>& palette) : palette_(palette) {}

    Rgb colorOf(std::size_t index) {
        if (index < palette_.size()) return palette_[index];
        if (invalid_++ == 0) first_ = index;
        return Rgb(0.0f);
    }

    /// Warns if there were indices beyond the palette.
    void report(const ImageFile& file) const;

  private:
    const std::vector<Rgb>& palette_;
    long long invalid_ = 0;
    std::size_t first_ = 0;
};

}  // namespace rayscope::image
