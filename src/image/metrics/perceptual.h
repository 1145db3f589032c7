#pragma once
// Measures of what a person sees. Both take display values: linear, from 0 to 1, finite.
#include <rayscope/image.h>

#include "image/metrics/plane.h"

namespace rayscope::image {

/// ꟻLIP of each pixel, 0 … 1: P. Andersson et al. 2020, "ꟻLIP: A Difference Evaluator for Alternating
/// Images". Constants are those of the paper; borders are continued by their nearest pixel.
Plane flipMap(const RgbImage& image, const RgbImage& reference, double pixelsPerDegree);

/// The structural similarity of each pixel's surroundings, 1 for equal: Z. Wang et al. 2004, "Image Quality
/// Assessment: From Error Visibility to Structural Similarity", of the sRGB-encoded luminance, with their
/// Gaussian window of standard deviation 1.5 over 11 × 11 pixels, continued beyond the border by the nearest
/// pixel.
Plane ssimMap(const RgbImage& image, const RgbImage& reference);

}  // namespace rayscope::image
