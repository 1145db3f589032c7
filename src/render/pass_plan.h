#pragma once
#include <algorithm>

namespace rayscope::render {

/// How many samples each pixel should have after the next pass. The plan decides how soon an image is seen,
/// never what it looks like.
inline int nextPassTarget(int samples, int targetSamples, bool progressive) {
    const int step = progressive ? std::max(1, samples) : 16;
    return std::min(samples + step, targetSamples);
}

}  // namespace rayscope::render
