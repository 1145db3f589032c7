#pragma once
#include <rayscope/image.h>
#include <rayscope/settings.h>
#include <stop_token>
#include <vector>

namespace rayscope::post {

/// One-dimensional filter weights for offsets −radius … radius in pixels, normalised to a sum of 1. The
/// two-dimensional filter is the outer product of the kernel with itself. A Gaussian weight is the integral
/// over its pixel, by error functions, so that the kernel tends to a unit impulse for sigma → 0 (exact at
/// sigma 0) and to a box for sigma → ∞.
std::vector<double> bloomKernel(BloomFilter filter, int radius, double sigma);

/// Keeps pixels with a channel above the threshold unchanged; all others become black, non-finite pixels too,
/// so that they do not spread.
RgbImage bloomThresholded(const RgbImage& image, float threshold);

/// Convolution with the outer product of the kernel; the image is black beyond its border. Throws Stopped
/// within some milliseconds of a stop.
RgbImage bloomFiltered(const RgbImage& image, const std::vector<double>& kernel,
                       const std::stop_token& stop = {});

/// The image with bloom as in the settings, or one stage of it if bloomDebug is on. Without bloom the image
/// itself. Throws Stopped like bloomFiltered().
RgbImage applyBloom(const RgbImage& image, const Settings& settings, const std::stop_token& stop = {});

}  // namespace rayscope::post
