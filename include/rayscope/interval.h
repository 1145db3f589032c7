#pragma once

namespace rayscope {

/// A measured value with its 95 % confidence interval.
struct Interval {
    double value = 0.0, lower = 0.0, upper = 0.0;
    bool contains(double x) const { return lower <= x && x <= upper; }
};

}  // namespace rayscope
