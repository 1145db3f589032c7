#pragma once
// Error metrics of an image against a reference.
#include <rayscope/image.h>
#include <string_view>
#include <vector>

namespace rayscope {

/// Each metric is 0 for equal images. The first four compare linear values, I of the image and R of the
/// reference; the last two are perceptual and compare what a display shows: linear values times 2^exposure,
/// clamped to 0 … 1.
enum class ErrorMetric {
    Rmse,    ///< root of the mean squared difference of all channels
    RelMse,  ///< mean of (I − R)² / (R² + 0.01) over all channels
    Smape,   ///< mean of |I − R| / (|I| + |R| + 0.01); 0 … 1 for values that are not negative
    Max,     ///< largest absolute difference of a channel
    Ssim,    ///< 1 − mean SSIM of the sRGB-encoded luminance (Wang et al. 2004)
    Flip     ///< mean ꟻLIP of low-dynamic-range images (Andersson et al. 2020)
};

/// "rmse", "relmse", "smape", "max", "ssim", "flip", in the order of the enumerators.
std::vector<std::string_view> errorMetricNames();
std::string_view nameOf(ErrorMetric metric);
/// Throws InputError, with the nearest name, if there is no such metric.
ErrorMetric errorMetricNamed(std::string_view name);

/// Range of CompareOptions::pixelsPerDegree. The filters of Flip are about half as many pixels wide.
inline constexpr double kMinPixelsPerDegree = 1.0, kMaxPixelsPerDegree = 1000.0;

struct CompareOptions {
    float exposure = 0.0f;  ///< stops, finite; for Ssim and Flip only

    /// Viewing distance for Flip, in pixels per degree of visual angle. The default is that of the paper: 0.7
    /// m from a display 0.7 m wide with 3840 pixels.
    double pixelsPerDegree = 67.0206;
};

/// The error of each pixel; NaN where the image or the reference is not finite. Rmse and Max have the unit of
/// the image, the others have none. Throws InputError if the sizes differ or there are no pixels, and
/// std::invalid_argument unless hasAllPixels() and the options are in range.
Image<double> errorMap(const RgbImage& image, const RgbImage& reference, ErrorMetric metric,
                       const CompareOptions& options = {});

/// A rectangle of an error map in pixels: x0 <= x < x1, y0 <= y < y1.
struct MapRegion {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
};

/// The metric of a whole map or of a region of it, over the finite pixels; NaN if there are none. Throws
/// std::invalid_argument if the region is not within the map.
double scoreOf(const Image<double>& map, ErrorMetric metric);
double scoreOf(const Image<double>& map, ErrorMetric metric, const MapRegion& region);

/// All metrics of one pair of images. Pixels that are not finite in either image are excluded and counted.
struct ErrorMeasures {
    double rmse = 0.0, relMse = 0.0, smape = 0.0, maximum = 0.0, flip = 0.0;
    double ssim = 0.0;               ///< the mean SSIM itself: 1 for equal images
    double relMseTrimmed = 0.0;      ///< RelMse without the 0.1 % of pixels with the largest relative error
    double meanDifference = 0.0;     ///< mean of I − R over all channels: the bias of the image as a whole
    int maximumX = 0, maximumY = 0;  ///< the pixel with the largest difference
    long long pixels = 0, pixelsCompared = 0;
    long long nonFiniteImage = 0, nonFiniteReference = 0;  ///< pixels with NaN or infinity

    double of(ErrorMetric metric) const;
};
/// Throws like errorMap().
ErrorMeasures measureErrors(const RgbImage& image, const RgbImage& reference,
                            const CompareOptions& options = {});

/// An error map in false colour, linear RGB: black for 0, through colours of increasing lightness, to white
/// for `range` and above (Green 2011, "A colour scheme for the display of astronomical intensity images").
/// Non-finite values become magenta.
RgbImage applyColorMap(const Image<double>& map, double range);

}  // namespace rayscope
