#include <rayscope/error_target.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/statistics.h"

namespace rayscope {

namespace {

constexpr int kTile = 32;
/// If one pixel holds more of the squared error than this, the next sample may well find another like it.
constexpr double kLargestShare = 0.5;

/// The squared error of the mean of both halves in one pixel, estimated from their difference; relative to
/// the brightness if asked for. Its expectation is the expected squared error.
double squaredError(const Rgb& a, const Rgb& b, ErrorMetric metric) {
    const glm::dvec3 difference = 0.5 * (glm::dvec3(a) - glm::dvec3(b));
    glm::dvec3 squares = difference * difference;
    if (metric == ErrorMetric::RelMse) {
        const glm::dvec3 mean = 0.5 * (glm::dvec3(a) + glm::dvec3(b));
        squares /= mean * mean + 0.01;
    }
    return (squares.x + squares.y + squares.z) / 3.0;
}

/// The part of the picture as a whole. `quantile` is the one-sided normal quantile of the confidence.
///
/// The error of this very picture is as random as its estimate: the sum and the difference of two halves vary
/// alike and independently. So the distance between both has √2 times the standard error of the estimate,
/// which comes from the spread between pixels. Squared errors are skewed; their logarithm is less so.
ErrorEstimate estimatePart(const RgbImage& a, const RgbImage& b, const PixelBounds& part, ErrorMetric metric,
                           double quantile) {
    double sum = 0.0, squares = 0.0, largest = 0.0, count = 0.0;
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            const double error = squaredError(a.at(x, y), b.at(x, y), metric);
            if (!std::isfinite(error)) continue;
            sum += error;
            squares += error * error;
            largest = std::max(largest, error);
            ++count;
        }
    }
    if (count < 2.0 || sum == 0.0) return {};
    const double mean = sum / count;
    const double variance = std::max(0.0, squares / count - mean * mean) * count / (count - 1.0);
    const double relative = std::sqrt(2.0 * variance / count) / mean;
    ErrorEstimate estimate{mean, mean * std::exp(quantile * relative), largest <= kLargestShare * sum};
    if (metric == ErrorMetric::Rmse) {
        estimate.error = std::sqrt(estimate.error);
        estimate.upper = std::sqrt(estimate.upper);
    }
    return estimate;
}

}  // namespace

ErrorEstimate estimateError(const RgbImage& halfA, const RgbImage& halfB, const PixelBounds& region,
                            const ErrorTarget& target) {
    constexpr double kNormal = std::numeric_limits<double>::infinity();
    if (!target.worstTile)
        return estimatePart(halfA, halfB, region, target.metric, studentQuantile(target.confidence, kNormal));
    std::vector<PixelBounds> tiles;
    for (int y = region.y0; y < region.y1; y += kTile)
        for (int x = region.x0; x < region.x1; x += kTile)
            tiles.push_back({x, std::min(x + kTile, region.x1), y, std::min(y + kTile, region.y1)});
    // Bonferroni: all bounds hold together if each holds with the confidence that leaves its part of the
    // risk.
    const double risk = (1.0 - target.confidence) / static_cast<double>(tiles.size());
    const double quantile = studentQuantile(1.0 - risk, kNormal);
    ErrorEstimate worst;
    for (const PixelBounds& tile : tiles) {
        const ErrorEstimate estimate = estimatePart(halfA, halfB, tile, target.metric, quantile);
        worst.error = std::max(worst.error, estimate.error);
        worst.upper = std::max(worst.upper, estimate.upper);
        worst.trusted = worst.trusted && (estimate.trusted || estimate.upper < target.error);
    }
    return worst;
}

}  // namespace rayscope
