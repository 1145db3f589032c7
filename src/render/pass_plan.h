#pragma once
#include <algorithm>

namespace rayscope::render {

/// The samples per pixel after the next pass. The plan affects how soon intermediate images are available,
/// never the final image.
inline int nextPassTarget(int samples, int targetSamples, bool progressive) {
    const int step = progressive ? std::max(1, samples) : 16;
    return std::min(samples + step, targetSamples);
}

}  // namespace rayscope::render
