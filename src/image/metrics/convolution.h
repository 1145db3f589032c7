#pragma once
// Separable convolution of single-channel images, for the perceptual metrics.
#include <rayscope/image.h>
#include <span>

namespace rayscope::image {

using Plane = Image<double>;

/// Convolves rows with `alongX`, then columns with `alongY`; both kernels have an odd number of weights.
/// Beyond the border the nearest pixel is repeated.
Plane convolve(const Plane& plane, std::span<const double> alongX, std::span<const double> alongY);

/// exp(−x² / (2 sigma²)) for x = −radius … radius, not normalised.
std::vector<double> gaussianWeights(double sigma, int radius);

}  // namespace rayscope::image
