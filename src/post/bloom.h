#pragma once
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <vector>

namespace rayscope::post {

/// One-dimensional filter weights for offsets −radius … radius; they sum to 1. The two-dimensional filter is
/// the outer product with itself. A Gaussian weight is the integral over its pixel, by error functions, so
/// that the filter tends to a single 1 as sigma goes to 0 and to a box as it grows; sigma 0 is the single 1.
std::vector<double> bloomKernel(BloomFilter filter, int radius, double sigma);

/// Pixels with a channel above the threshold, whole; all others black. Pixels that are not finite stay out,
/// so that they cannot spread.
RgbImage bloomThresholded(const RgbImage& image, float threshold);

/// Convolution with the outer product of the kernel; beyond the border the image is black.
RgbImage bloomFiltered(const RgbImage& image, const std::vector<double>& kernel);

/// The image with its bloom as the settings say, or, in the debug view, one stage of it. Without bloom the
/// image itself.
RgbImage applyBloom(const RgbImage& image, const Settings& settings);

}  // namespace rayscope::post
