#pragma once
#include <rayscope/image.h>

#include <cmath>

namespace rayscope::test {

/// Root mean square difference over all channels of two images of the same size.
inline double distanceOf(const RgbImage& a, const RgbImage& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
        squares += glm::dot(d, d) / 3.0;
    }
    return std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

}  // namespace rayscope::test
