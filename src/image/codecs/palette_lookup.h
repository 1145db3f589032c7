#pragma once
#include <rayscope/image.h>

#include <vector>

#include "image/codecs/image_file.h"

namespace rayscope::image {

/// Looks up colours of a palette and counts the indices outside of it, which are black.
class PaletteLookup {
  public:
    /// `firstIndex`: that of the first colour.
    explicit PaletteLookup(const std::vector<Rgb>& palette, std::size_t firstIndex = 0)
        : palette_(palette), firstIndex_(firstIndex) {}

    Rgb colorOf(std::size_t index) {
        if (index >= firstIndex_ && index - firstIndex_ < palette_.size())
            return palette_[index - firstIndex_];
        if (invalid_++ == 0) firstInvalid_ = index;
        return Rgb(0.0f);
    }

    /// Warns if there were indices beyond the palette.
    void report(const ImageFile& file) const;

  private:
    const std::vector<Rgb>& palette_;
    long long invalid_ = 0;
    std::size_t firstIndex_, firstInvalid_ = 0;
};

}  // namespace rayscope::image
