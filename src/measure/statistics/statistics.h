#pragma once
// Confidence intervals for small samples.
#include <rayscope/interval.h>
#include <span>
#include <vector>

namespace rayscope::measure {

/// Quantile of Student's t distribution; `probability` in (0, 1), `degrees` of freedom ≥ 1, infinity for the
/// normal distribution.
double studentQuantile(double probability, double degrees);

/// The mean with its confidence interval by Student's t; infinitely wide for one value.
Interval meanInterval(std::span<const double> values, double confidence = 0.95);

/// The mean with the prediction interval of the next value, for normally distributed values.
Interval predictionInterval(std::span<const double> values, double confidence = 0.95);

/// The median with a confidence interval between two order statistics, valid for any distribution. Fewer than
/// six values have no such interval at 95 %; then Student's t on their logarithms, for positive values.
Interval medianInterval(std::span<const double> values, double confidence = 0.95);

/// The median of a[i] / b[i]. Changes in machine load that affect both values of a pair cancel.
Interval ratioInterval(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

/// The interval of the square roots; negative values count as zero.
Interval rootOf(const Interval& squares);

/// Least-squares slope of y over x; needs two different x.
double slopeOf(std::span<const double> x, std::span<const double> y);

}  // namespace rayscope::measure
