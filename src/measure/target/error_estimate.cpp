#include <rayscope/error_target.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "measure/statistics/statistics.h"

namespace rayscope {

namespace {

constexpr int kTile = 32;
/// If one pixel holds more of the squared error than this, the next sample may well find another like it.
constexpr double kLargestShare = 0.5;

/// How what pixels have adds up, and whether few of them hold most of it.
struct PixelTotals {
    double sum = 0.0, squares = 0.0, largest = 0.0, count = 0.0;

    void add(double value) {
        sum += value;
        squares += value * value;
        largest = std::max(largest, value);
        ++count;
    }
    double mean() const { return sum / count; }
    bool isHeldByOne() const { return largest > kLargestShare * sum; }
};

glm::dvec3 meanOf(const Rgb& a, const Rgb& b) { return 0.5 * (glm::dvec3(a) + glm::dvec3(b)); }

/// What relative squared errors are relative to; 1 for others.
glm::dvec3 unitOf(const glm::dvec3& mean, ErrorMetric metric) {
    return metric == ErrorMetric::RelMse ? mean * mean + 0.01 : glm::dvec3(1.0);
}

double meanOf(const glm::dvec3& c) { return (c.x + c.y + c.z) / 3.0; }

/// The standard error of the estimate, relative to it. The squared error of a pixel is the square of about a
/// Gaussian, which varies by √2 of its expectation; and the expectations are in proportion to the variances
/// of the samples within the pixels, which are known far better than from one difference. Without them, from
/// the spread between pixels.
double relativeStandardError(const PixelTotals& errors, const PixelTotals& spreads) {
    if (spreads.sum > 0.0) return std::sqrt(2.0 * spreads.squares) / spreads.sum;
    const double mean = errors.mean(), n = errors.count;
    const double variance = std::max(0.0, errors.squares / n - mean * mean) * n / (n - 1.0);
    return std::sqrt(variance / n) / mean;
}

/// The part of the picture as a whole. `quantile` is the one-sided normal quantile of the confidence.
///
/// Half the difference of the halves has the expected square of the error of their mean. The error of this
/// very picture is as random as that estimate: the sum and the difference of two halves vary alike and
/// independently. So the distance between both has √2 times the standard error of the estimate. Squared
/// errors are skewed; their logarithm is less so. What a few pixels hold is not trusted; but that must show
/// in their samples, too, since any single difference may happen to be large.
ErrorEstimate estimatePart(const RgbImage& a, const RgbImage& b, const PixelBounds& part, ErrorMetric metric,
                           double quantile, const VarianceImage* spread) {
    PixelTotals errors, spreads;
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            const glm::dvec3 half = 0.5 * (glm::dvec3(a.at(x, y)) - glm::dvec3(b.at(x, y)));
            const glm::dvec3 unit = unitOf(meanOf(a.at(x, y), b.at(x, y)), metric);
            const double error = meanOf(half * half / unit);
            if (!std::isfinite(error)) continue;
            errors.add(error);
            const double ofSamples = spread ? spread->at(x, y) / meanOf(unit) : 0.0;
            if (std::isfinite(ofSamples)) spreads.add(ofSamples);
        }
    }
    if (errors.count < 2.0 || errors.sum == 0.0) return {};
    const double mean = errors.mean();
    const double distance = std::numbers::sqrt2 * relativeStandardError(errors, spreads);
    ErrorEstimate estimate{mean, mean * std::exp(quantile * distance),
                           !errors.isHeldByOne() || (spread && !spreads.isHeldByOne())};
    if (metric == ErrorMetric::Rmse) {
        estimate.error = std::sqrt(estimate.error);
        estimate.upper = std::sqrt(estimate.upper);
    }
    return estimate;
}

}  // namespace

ErrorEstimate estimateError(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                            const ErrorTarget& target, const VarianceImage* spread) {
    constexpr double kNormal = std::numeric_limits<double>::infinity();
    if (!target.worstTile)
        return estimatePart(halfA, halfB, region, target.metric,
                            measure::studentQuantile(target.confidence, kNormal), spread);
    std::vector<PixelBounds> tiles;
    for (int y = region.y0; y < region.y1; y += kTile)
        for (int x = region.x0; x < region.x1; x += kTile)
            tiles.push_back({x, std::min(x + kTile, region.x1), y, std::min(y + kTile, region.y1)});
    // Bonferroni: all bounds hold together if each holds with the confidence that leaves its part of the
    // risk.
    const double risk = (1.0 - target.confidence) / static_cast<double>(tiles.size());
    const double quantile = measure::studentQuantile(1.0 - risk, kNormal);
    ErrorEstimate worst;
    for (const PixelBounds& tile : tiles) {
        const ErrorEstimate estimate = estimatePart(halfA, halfB, tile, target.metric, quantile, spread);
        worst.error = std::max(worst.error, estimate.error);
        worst.upper = std::max(worst.upper, estimate.upper);
        worst.trusted = worst.trusted && (estimate.trusted || estimate.upper < target.error);
    }
    return worst;
}

}  // namespace rayscope
