#include "image/plane.h"

#include <algorithm>
#include <cmath>

namespace rayscope {

namespace {

/// Convolves along x; the second pass is the same on the transposed plane.
Plane convolvedRowsTransposed(const Plane& plane, std::span<const double> kernel) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane result(plane.height, plane.width);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0.0;
            for (int i = -radius; i <= radius; ++i)
                sum += kernel[static_cast<std::size_t>(i + radius)] *
                       plane.at(std::clamp(x + i, 0, plane.width - 1), y);
            result.at(y, x) = sum;
        }
    }
    return result;
}

}  // namespace

Plane convolve(const Plane& plane, std::span<const double> alongX, std::span<const double> alongY) {
    return convolvedRowsTransposed(convolvedRowsTransposed(plane, alongX), alongY);
}

std::vector<double> gaussianWeights(double sigma, int radius) {
    std::vector<double> weights;
    for (int x = -radius; x <= radius; ++x) weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
    return weights;
}

}  // namespace rayscope
