#include "measure/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rayscope::measure {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The regularised incomplete beta function I_x(a, b) by its continued fraction (Numerical Recipes, 6.4;
/// Lentz's method), for x below (a + 1) / (a + b + 2).
double incompleteBetaFraction(double a, double b, double x) {
    constexpr double kTiny = 1e-300;
    double c = 1.0, d = 1.0 / std::max(1.0 - (a + b) * x / (a + 1.0), kTiny), result = d;
    for (int m = 1; m < 1000; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1.0) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1.0));
        double factor = 1.0;
        for (const double term : {even, odd}) {
            d = 1.0 + term * d;
            c = 1.0 + term / c;
            if (std::abs(d) < kTiny) d = kTiny;
            if (std::abs(c) < kTiny) c = kTiny;
            d = 1.0 / d;
            factor = c * d;
            result *= factor;
        }
        if (std::abs(factor - 1.0) < 1e-15) break;
    }
    const double front =
        std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x);
    return std::exp(front) / a * result;
}

double incompleteBeta(double a, double b, double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    if (x < (a + 1.0) / (a + b + 2.0)) return incompleteBetaFraction(a, b, x);
    return 1.0 - incompleteBetaFraction(b, a, 1.0 - x);
}

/// P(T ≤ t) for t ≥ 0.
double studentCdf(double t, double degrees) {
    if (std::isinf(degrees)) return 0.5 * std::erfc(-t / std::sqrt(2.0));
    return 1.0 - 0.5 * incompleteBeta(0.5 * degrees, 0.5, degrees / (degrees + t * t));
}

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sample variance; the mean is subtracted first, so nothing cancels.
double varianceOf(std::span<const double> values) {
    const double mean = meanOf(values);
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return squares / (static_cast<double>(values.size()) - 1.0);
}

/// Mean ± t · √(variance · factor).
Interval studentInterval(std::span<const double> values, double confidence, double factor) {
    const double mean = meanOf(values);
    if (values.size() < 2) return {mean, -kInfinity, kInfinity};
    const double t = studentQuantile(0.5 + 0.5 * confidence, static_cast<double>(values.size()) - 1.0);
    const double half = t * std::sqrt(varianceOf(values) * factor);
    return {mean, mean - half, mean + half};
}

double medianOfSorted(const std::vector<double>& sorted) {
    const std::size_t n = sorted.size();
    return n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

/// The largest number of order statistics that can be dropped at each end while the interval between the
/// remaining ones covers the median with `confidence`; negative if even all values do not.
int droppedOrderStatistics(std::size_t n, double confidence) {
    double below = 0.0, probability = std::pow(0.5, static_cast<double>(n));
    int dropped = -1;
    for (std::size_t k = 0; k < n; ++k) {
        below += probability;  // P(at most k values lie below the median)
        if (1.0 - 2.0 * below < confidence) break;
        dropped = static_cast<int>(k);
        probability *= static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return dropped;
}

}  // namespace

double studentQuantile(double probability, double degrees) {
    if (probability < 0.5) return -studentQuantile(1.0 - probability, degrees);
    double lower = 0.0, upper = 1.0;
    while (studentCdf(upper, degrees) < probability && upper < 1e300) upper *= 2.0;
    for (int i = 0; i < 200 && upper - lower > 1e-13 * upper; ++i) {
        const double middle = 0.5 * (lower + upper);
        (studentCdf(middle, degrees) < probability ? lower : upper) = middle;
    }
    return 0.5 * (lower + upper);
}

Interval meanInterval(std::span<const double> values, double confidence) {
    return studentInterval(values, confidence, 1.0 / static_cast<double>(values.size()));
}

Interval predictionInterval(std::span<const double> values, double confidence) {
    return studentInterval(values, confidence, 1.0 + 1.0 / static_cast<double>(values.size()));
}

Interval medianInterval(std::span<const double> values, double confidence) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double median = medianOfSorted(sorted);
    if (sorted.size() == 1) return {median, 0.0, kInfinity};
    const int dropped = droppedOrderStatistics(sorted.size(), confidence);
    if (dropped >= 0) {
        const auto k = static_cast<std::size_t>(dropped);
        return {median, sorted[k], sorted[sorted.size() - 1 - k]};
    }
    std::vector<double> logarithms;
    for (const double value : sorted) logarithms.push_back(std::log(std::max(value, 1e-300)));
    const Interval t = meanInterval(logarithms, confidence);
    return {median, std::min(std::exp(t.lower), median), std::max(std::exp(t.upper), median)};
}

Interval ratioInterval(std::span<const double> a, std::span<const double> b, double confidence) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) ratios.push_back(a[i] / b[i]);
    return medianInterval(ratios, confidence);
}

Interval rootOf(const Interval& squares) {
    const auto root = [](double value) { return std::sqrt(std::max(value, 0.0)); };
    return {root(squares.value), root(squares.lower), root(squares.upper)};
}

double slopeOf(std::span<const double> x, std::span<const double> y) {
    const double meanX = meanOf(x), meanY = meanOf(y);
    double xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
    }
    return xy / xx;
}

}  // namespace rayscope::measure
