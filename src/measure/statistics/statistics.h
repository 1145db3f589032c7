#pragma once
// What can be said from few noisy measurements, and with what confidence. No figure leaves this room without
// its interval.
#include <rayscope/interval.h>
#include <span>
#include <vector>

namespace rayscope::measure {

/// The value below which a Student-t variable with `degrees` degrees of freedom lies with `probability`, in
/// (0, 1); degrees ≥ 1, infinity gives the normal distribution.
double studentQuantile(double probability, double degrees);

/// The mean and where the true mean lies with `confidence`, by Student's t; infinitely wide for one value.
Interval meanInterval(std::span<const double> values, double confidence = 0.95);

/// Where the next value will lie.
Interval nextValueInterval(std::span<const double> values, double confidence = 0.95);

/// The median and an interval that covers the true median with at least `confidence`, between two order
/// statistics (free of assumptions on the distribution). With fewer than six positive values no two of them
/// cover 95 %; then Student's t on their logarithms.
Interval medianInterval(std::span<const double> values, double confidence = 0.95);

/// The median of a[i] / b[i], measured in pairs, so that what slows the machine down for both cancels.
Interval ratioInterval(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

/// An interval of squares as one of their roots; what is below zero counts as zero.
Interval rootOf(const Interval& squares);

/// Least-squares slope of y over x; at least two different x.
double slopeOf(std::span<const double> x, std::span<const double> y);

}  // namespace rayscope::measure
