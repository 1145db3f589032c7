#include "image/metrics/convolution.h"

#include <algorithm>
#include <cmath>

namespace rayscope::image {

namespace {

/// Convolves along x and transposes, so that calling it twice convolves along both axes.
Plane convolveRowsAndTranspose(const Plane& plane, std::span<const double> kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    const auto width = static_cast<std::size_t>(plane.width);
    Plane result(plane.height, plane.width);
    std::vector<double> row(width + kernel.size() - 1), sums(width);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = -radius; x < plane.width + radius; ++x)
            row[static_cast<std::size_t>(x + radius)] = plane.at(std::clamp(x, 0, plane.width - 1), y);
        std::fill(sums.begin(), sums.end(), 0.0);
        for (std::size_t i = 0; i < kernel.size(); ++i)
            for (std::size_t x = 0; x < width; ++x) sums[x] += kernel[i] * row[x + i];
        for (int x = 0; x < plane.width; ++x) result.at(y, x) = sums[static_cast<std::size_t>(x)];
    }
    return result;
}

}  // namespace

Plane convolve(const Plane& plane, std::span<const double> alongX, std::span<const double> alongY) {
    return convolveRowsAndTranspose(convolveRowsAndTranspose(plane, alongX), alongY);
}

std::vector<double> gaussianWeights(double sigma, int radius) {
    std::vector<double> weights;
    for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
    return weights;
}

}  // namespace rayscope::image
