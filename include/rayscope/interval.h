#pragma once

namespace rayscope {

/// A measured value and where the true one lies with 95 % confidence.
struct Interval {
    double value = 0.0, lower = 0.0, upper = 0.0;
    bool contains(double x) const { return lower <= x && x <= upper; }
};

}  // namespace rayscope
