#pragma once
// Single channels and their convolution, as perceptual measures need them.
#include <rayscope/image.h>
#include <span>

namespace rayscope::image {

using Plane = Image<double>;

/// Convolves with `along x` in rows and `along y` in columns; both kernels have an odd number of weights.
/// Beyond the border the nearest pixel counts.
Plane convolve(const Plane& plane, std::span<const double> alongX, std::span<const double> alongY);

/// exp(−x² / (2 sigma²)) for x = −radius … radius, not normalised.
std::vector<double> gaussianWeights(double sigma, int radius);

}  // namespace rayscope::image
