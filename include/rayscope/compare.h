#pragma once
// How far an image is from a reference, in the measures that the field uses.
#include <rayscope/image.h>
#include <string_view>
#include <vector>

namespace rayscope {

/// Each measure is 0 for equal images. The first four compare linear values; the last two what a person sees
/// on a display: linear values times 2^exposure, cut to 0 … 1.
enum class ErrorMetric {
    Rmse,    ///< root of the mean squared difference of all channels
    RelMse,  ///< mean of (I − R)² / (R² + 0.01) over all channels
    Smape,   ///< mean of |I − R| / (|I| + |R| + 0.01); 0 … 1 for values that are not negative
    Max,     ///< largest difference of a channel
    Ssim,    ///< 1 − mean SSIM of the sRGB-encoded luminance (Wang et al. 2004)
    Flip     ///< mean ꟻLIP of low-dynamic-range images (Andersson et al. 2020)
};

/// "rmse", "relmse", "smape", "max", "ssim", "flip", in the order of the enumerators.
std::vector<std::string_view> errorMetricNames();
std::string_view nameOf(ErrorMetric metric);
/// Throws InputError that names the nearest metric.
ErrorMetric errorMetricNamed(std::string_view name);

struct CompareOptions {
    float exposure = 0.0f;             ///< stops, for Ssim and Flip only
    double pixelsPerDegree = 67.0206;  ///< of the observer, for Flip: 0.7 m from a 0.7 m wide display of 3840
};

/// The error of each pixel; NaN where the image or the reference is not finite. Rmse and Max are in units of
/// the image, the others without unit. Throws InputError if the sizes differ.
Image<double> errorMap(const RgbImage& image, const RgbImage& reference, ErrorMetric metric,
                       const CompareOptions& options = {});

/// A half-open rectangle of an error map.
struct MapRegion {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
};

/// The measure of a whole map, or of a part of it, over its finite pixels; NaN if there are none.
double scoreOf(const Image<double>& map, ErrorMetric metric);
double scoreOf(const Image<double>& map, ErrorMetric metric, const MapRegion& region);

/// All measures at once. Pixels that are not finite in either image are left out of all of them and counted.
struct ErrorMeasures {
    double rmse = 0.0, relMse = 0.0, smape = 0.0, maximum = 0.0, ssim = 0.0, flip = 0.0;
    double relMseTrimmed = 0.0;   ///< without the 0.1 % of pixels with the largest relative error
    double meanDifference = 0.0;  ///< I − R, of all channels: what a bias of the whole image would be
    int maximumX = 0, maximumY = 0;
    long long pixels = 0, pixelsCompared = 0;
    long long nonFiniteImage = 0, nonFiniteReference = 0;  ///< pixels with NaN or infinity

    double of(ErrorMetric metric) const;
};
ErrorMeasures measureErrors(const RgbImage& image, const RgbImage& reference,
                            const CompareOptions& options = {});

/// An error map as a picture: black for 0, through colours of growing lightness, to white for `range` and
/// above (Green 2011, "A colour scheme for the display of astronomical intensity images"); what is not finite
/// becomes magenta. The values are linear.
RgbImage applyColorMap(const Image<double>& map, double range);

}  // namespace rayscope
