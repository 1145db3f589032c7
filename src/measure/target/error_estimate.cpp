#include <rayscope/error_target.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/statistics/statistics.h"
#include "measure/target/check_target.h"

namespace rayscope {

namespace {

constexpr int kTile = 32;
/// Largest fraction of the squared error in one pixel with which an estimate counts as reliable: above it,
/// other pixels may have such a rare contribution that is not sampled yet.
constexpr double kMaxPixelFraction = 0.5;

/// Sums of a non-negative quantity over pixels.
struct PixelTotals {
    double sum = 0.0, squares = 0.0, largest = 0.0, count = 0.0;

    void add(double value) {
        sum += value;
        squares += value * value;
        largest = std::max(largest, value);
        ++count;
    }
    double mean() const { return sum / count; }
    bool isDominatedByOne() const { return largest > kMaxPixelFraction * sum; }
};

glm::dvec3 meanOf(const Rgb& a, const Rgb& b) { return 0.5 * (glm::dvec3(a) + glm::dvec3(b)); }

/// The denominator of relative squared errors; 1 for absolute ones.
glm::dvec3 denominatorOf(const glm::dvec3& mean, ErrorMetric metric) {
    return metric == ErrorMetric::RelMse ? mean * mean + 0.01 : glm::dvec3(1.0);
}

double meanOf(const glm::dvec3& c) { return (c.x + c.y + c.z) / 3.0; }

/// Relative standard error of the estimate. The difference of a pixel is nearly Gaussian, so the standard
/// deviation of its square is √2 times the expectation. The expectations are proportional to the sample
/// variances within the pixels, which are far more accurate than single differences. Without sample
/// variances, from the variance of the squared differences over pixels.
double relativeStandardError(const PixelTotals& errors, const PixelTotals& variances) {
    if (variances.sum > 0.0) return std::sqrt(2.0 * variances.squares) / variances.sum;
    const double mean = errors.mean(), n = errors.count;
    const double variance = std::max(0.0, errors.squares / n - mean * mean) * n / (n - 1.0);
    return std::sqrt(variance / n) / mean;
}

/// The error over `region`. `quantile` is the one-sided normal quantile of the confidence level.
///
/// Half the difference of the halves has the same expected square as the error of their mean. The squared
/// error of this particular picture varies as much as its estimate and independently of it, since sum and
/// difference of two halves are uncorrelated with equal variance. So the standard deviation of their
/// difference is √2 times the standard error of the estimate. The bound is computed for the logarithm, which
/// is less skewed. An estimate is unreliable if one pixel dominates both the squared differences and the
/// sample variances; a single difference may be large by chance.
ErrorEstimate estimateRegion(const RgbImage& a, const RgbImage& b, const PixelBounds& region,
                             ErrorMetric metric, double quantile, const VarianceImage* variance) {
    PixelTotals errors, variances;
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const glm::dvec3 half = 0.5 * (glm::dvec3(a.at(x, y)) - glm::dvec3(b.at(x, y)));
            const glm::dvec3 denominator = denominatorOf(meanOf(a.at(x, y), b.at(x, y)), metric);
            const double error = meanOf(half * half / denominator);
            if (!std::isfinite(error)) continue;
            errors.add(error);
            const double sampleVariance = variance ? variance->at(x, y) / meanOf(denominator) : 0.0;
            if (std::isfinite(sampleVariance)) variances.add(sampleVariance);
        }
    }
    if (errors.count < 2.0 || errors.sum == 0.0) return {};
    const double mean = errors.mean();
    const double distance = std::numbers::sqrt2 * relativeStandardError(errors, variances);
    ErrorEstimate estimate{mean, mean * std::exp(quantile * distance),
                           !errors.isDominatedByOne() || (variance && !variances.isDominatedByOne())};
    if (metric == ErrorMetric::Rmse) {
        estimate.error = std::sqrt(estimate.error);
        estimate.upper = std::sqrt(estimate.upper);
    }
    return estimate;
}

/// Throws std::invalid_argument unless all images have the size of the first and contain the region.
void checkImages(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                 const VarianceImage* variance) {
    using base::checkArgument;
    const auto isSame = [&](const auto& image) {
        return image.width == halfA.width && image.height == halfA.height && hasAllPixels(image);
    };
    checkArgument(isSame(halfA) && isSame(halfB), "halfA and halfB differ in size or lack pixels");
    checkArgument(!variance || isSame(*variance), "variance has another size than the halves");
    checkArgument(region.x0 >= 0 && region.x0 < region.x1 && region.x1 <= halfA.width && region.y0 >= 0 &&
                      region.y0 < region.y1 && region.y1 <= halfA.height,
                  "region is empty or outside the halves");
}

}  // namespace

ErrorEstimate estimateError(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                            const ErrorTarget& target, const VarianceImage* variance) {
    measure::checkTarget(target);
    checkImages(halfA, halfB, region, variance);
    constexpr double kNormal = std::numeric_limits<double>::infinity();
    if (!target.worstTile)
        return estimateRegion(halfA, halfB, region, target.metric,
                              measure::studentQuantile(target.confidence, kNormal), variance);
    std::vector<PixelBounds> tiles;
    for (int y = region.y0; y < region.y1; y += kTile)
        for (int x = region.x0; x < region.x1; x += kTile)
            tiles.push_back({x, std::min(x + kTile, region.x1), y, std::min(y + kTile, region.y1)});
    // Bonferroni correction, so that the bounds of all tiles hold together.
    const double risk = (1.0 - target.confidence) / static_cast<double>(tiles.size());
    const double quantile = measure::studentQuantile(1.0 - risk, kNormal);
    ErrorEstimate worst;
    for (const PixelBounds& tile : tiles) {
        const ErrorEstimate estimate = estimateRegion(halfA, halfB, tile, target.metric, quantile, variance);
        worst.error = std::max(worst.error, estimate.error);
        worst.upper = std::max(worst.upper, estimate.upper);
        worst.reliable = worst.reliable && (estimate.reliable || estimate.upper < target.error);
    }
    return worst;
}

}  // namespace rayscope
