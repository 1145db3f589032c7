#pragma once
// Perceptual metrics. Both take display values: linear, from 0 to 1, finite.
#include <rayscope/image.h>

#include "image/metrics/convolution.h"

namespace rayscope::image {

/// ꟻLIP of each pixel, 0 … 1, with the constants of P. Andersson et al. 2020, "ꟻLIP: A Difference Evaluator
/// for Alternating Images". Beyond the border the nearest pixel is repeated. `pixelsPerDegree` of visual
/// angle.
Plane flipMap(const RgbImage& image, const RgbImage& reference, double pixelsPerDegree);

/// Structural similarity (SSIM) of the sRGB-encoded luminance around each pixel, −1 … 1, 1 for equal: Z. Wang
/// et al. 2004, "Image Quality Assessment: From Error Visibility to Structural Similarity", with their
/// Gaussian window of standard deviation 1.5 over 11 × 11 pixels. Beyond the border the nearest pixel is
/// repeated.
Plane ssimMap(const RgbImage& image, const RgbImage& reference);

}  // namespace rayscope::image
