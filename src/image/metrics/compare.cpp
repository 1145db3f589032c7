#include <fmt/format.h>
#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check_argument.h"
#include "base/nearest_name.h"
#include "image/metrics/check_images.h"
#include "image/metrics/perceptual_metrics.h"
#include "math/vectors.h"

namespace rayscope {

namespace {

constexpr std::array<std::string_view, 6> kNames{"rmse", "relmse", "smape", "max", "ssim", "flip"};
/// Added to the denominators of relative metrics, so that they stay finite where the reference is black.
constexpr double kEpsilon = 0.01;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Filters grow with the pixels per degree: at the limit they are some hundred pixels wide.
void checkOptions(const CompareOptions& options) {
    base::checkArgument(
        options.pixelsPerDegree >= kMinPixelsPerDegree && options.pixelsPerDegree <= kMaxPixelsPerDegree,
        "options: pixelsPerDegree is {}; expected {} … {}", options.pixelsPerDegree, kMinPixelsPerDegree,
        kMaxPixelsPerDegree);
    base::checkArgument(std::isfinite(options.exposure), "options: exposure is not finite");
}

void checkMetric(ErrorMetric metric) {
    base::checkArgument(metric >= ErrorMetric::Rmse && metric <= ErrorMetric::Flip,
                        "metric is no enumerator");
}

double pixelError(const Rgb& pixel, const Rgb& reference, ErrorMetric metric) {
    const glm::dvec3 a(pixel), r(reference), d = a - r;
    switch (metric) {
        case ErrorMetric::Rmse:
            return std::sqrt(glm::dot(d, d) / 3.0);
        case ErrorMetric::RelMse: {
            const glm::dvec3 relative = d * d / (r * r + kEpsilon);
            return (relative.x + relative.y + relative.z) / 3.0;
        }
        case ErrorMetric::Smape: {
            const glm::dvec3 relative = glm::abs(d) / (glm::abs(a) + glm::abs(r) + kEpsilon);
            return (relative.x + relative.y + relative.z) / 3.0;
        }
        default:
            return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
}

/// Exposes and clamps both to what a display shows. Pixels that are not finite in either become black in
/// both, so that they do not spread through the filters.
void clampToDisplay(RgbImage& image, RgbImage& reference, float exposure) {
    const float factor = std::exp2(exposure);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        Rgb &a = image.pixels[i], &b = reference.pixels[i];
        const bool finite = math::isFinite(a) && math::isFinite(b);
        a = finite ? glm::clamp(a * factor, 0.0f, 1.0f) : Rgb(0.0f);
        b = finite ? glm::clamp(b * factor, 0.0f, 1.0f) : Rgb(0.0f);
    }
}

Image<double> perceptualMap(RgbImage image, RgbImage reference, ErrorMetric metric,
                            const CompareOptions& options) {
    clampToDisplay(image, reference, options.exposure);
    if (metric == ErrorMetric::Flip) return image::flipMap(image, reference, options.pixelsPerDegree);
    Image<double> map = image::ssimMap(image, reference);
    for (double& value : map.pixels) value = 1.0 - value;
    return map;
}

double trimmedMean(std::vector<double> values, double dropped) {
    std::erase_if(values, [](double v) { return std::isnan(v); });
    const auto kept = values.size() - static_cast<std::size_t>(dropped * static_cast<double>(values.size()));
    if (kept == 0) return kNaN;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(kept - 1), values.end());
    double sum = 0.0;
    for (std::size_t i = 0; i < kept; ++i) sum += values[i];
    return sum / static_cast<double>(kept);
}

}  // namespace

std::vector<std::string_view> errorMetricNames() { return {kNames.begin(), kNames.end()}; }
std::string_view nameOf(ErrorMetric metric) { return kNames[static_cast<std::size_t>(metric)]; }

ErrorMetric errorMetricNamed(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
        throw InputError(fmt::format("unknown metric '{}'{}; expected {}", name,
                                     base::didYouMean(name, kNames), base::joinChoices(kNames)));
    return static_cast<ErrorMetric>(found - kNames.begin());
}

Image<double> errorMap(const RgbImage& image, const RgbImage& reference, ErrorMetric metric,
                       const CompareOptions& options) {
    image::checkComparable(image, reference);
    checkOptions(options);
    checkMetric(metric);
    const bool perceptual = metric == ErrorMetric::Ssim || metric == ErrorMetric::Flip;
    Image<double> map = perceptual ? perceptualMap(image, reference, metric, options)
                                   : Image<double>(image.width, image.height);
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const Rgb &a = image.pixels[i], &r = reference.pixels[i];
        if (!math::isFinite(a) || !math::isFinite(r))
            map.pixels[i] = kNaN;
        else if (!perceptual)
            map.pixels[i] = pixelError(a, r, metric);
    }
    return map;
}

void image::checkComparable(const RgbImage& image, const RgbImage& reference) {
    base::checkArgument(hasAllPixels(image) && hasAllPixels(reference),
                        "image or reference: pixels.size() is not width * height");
    if (image.width != reference.width || image.height != reference.height)
        throw InputError(
            fmt::format("image sizes differ: {} x {} and {} x {} pixels; render both with the same --size",
                        image.width, image.height, reference.width, reference.height));
    if (image.empty()) throw InputError("the images have no pixels");
}

double scoreOf(const Image<double>& map, ErrorMetric metric) {
    return scoreOf(map, metric, {0, map.width, 0, map.height});
}

double scoreOf(const Image<double>& map, ErrorMetric metric, const MapRegion& region) {
    checkMetric(metric);
    base::checkArgument(hasAllPixels(map), "map: pixels.size() is not width * height");
    base::checkArgument(region.x0 >= 0 && region.x1 <= map.width && region.y0 >= 0 && region.y1 <= map.height,
                        "region is outside the map");
    double sum = 0.0, largest = 0.0;
    long long count = 0;
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const double error = map.at(x, y);
            if (std::isnan(error)) continue;
            sum += metric == ErrorMetric::Rmse ? error * error : error;
            largest = std::max(largest, error);
            ++count;
        }
    }
    if (count == 0) return kNaN;
    if (metric == ErrorMetric::Max) return largest;
    const double mean = sum / static_cast<double>(count);
    return metric == ErrorMetric::Rmse ? std::sqrt(mean) : mean;
}

double ErrorMeasures::of(ErrorMetric metric) const {
    switch (metric) {
        case ErrorMetric::Rmse:
            return rmse;
        case ErrorMetric::RelMse:
            return relMse;
        case ErrorMetric::Smape:
            return smape;
        case ErrorMetric::Max:
            return maximum;
        case ErrorMetric::Ssim:
            return 1.0 - ssim;
        case ErrorMetric::Flip:
            return flip;
    }
    return kNaN;
}

ErrorMeasures measureErrors(const RgbImage& image, const RgbImage& reference, const CompareOptions& options) {
    const auto score = [&](ErrorMetric metric) {
        return scoreOf(errorMap(image, reference, metric, options), metric);
    };
    ErrorMeasures all;
    all.rmse = score(ErrorMetric::Rmse);
    all.smape = score(ErrorMetric::Smape);
    all.ssim = 1.0 - score(ErrorMetric::Ssim);
    all.flip = score(ErrorMetric::Flip);
    const Image<double> relative = errorMap(image, reference, ErrorMetric::RelMse);
    all.relMse = scoreOf(relative, ErrorMetric::RelMse);
    all.relMseTrimmed = trimmedMean(relative.pixels, 0.001);

    const Image<double> largest = errorMap(image, reference, ErrorMetric::Max);
    all.maximum = scoreOf(largest, ErrorMetric::Max);
    const auto at = std::find(largest.pixels.begin(), largest.pixels.end(), all.maximum);
    if (at != largest.pixels.end()) {
        const auto index = static_cast<int>(at - largest.pixels.begin());
        all.maximumX = index % largest.width;
        all.maximumY = index / largest.width;
    }
    RgbSum difference(0.0);
    all.pixels = static_cast<long long>(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const bool finiteImage = math::isFinite(image.pixels[i]),
                   finiteReference = math::isFinite(reference.pixels[i]);
        all.nonFiniteImage += !finiteImage;
        all.nonFiniteReference += !finiteReference;
        if (!finiteImage || !finiteReference) continue;
        ++all.pixelsCompared;
        difference += RgbSum(image.pixels[i]) - RgbSum(reference.pixels[i]);
    }
    all.meanDifference =
        (difference.x + difference.y + difference.z) / (3.0 * static_cast<double>(all.pixelsCompared));
    return all;
}

}  // namespace rayscope
