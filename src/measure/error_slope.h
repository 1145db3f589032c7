#pragma once
#include <rayscope/error_target.h>
#include <utility>
#include <vector>

namespace rayscope {

/// Looks at a picture that grows: samples per pixel, estimate.
using ErrorLooks = std::vector<std::pair<int, ErrorEstimate>>;

/// −d log √(squared error) / d log samples of the last looks, within what samplers can do; a half before
/// there are two. Estimates by RelMse are squares.
double errorSlope(const ErrorLooks& looks, ErrorMetric metric);

}  // namespace rayscope
