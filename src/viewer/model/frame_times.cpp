#include "viewer/model/frame_times.h"

#include <algorithm>
#include <cmath>

namespace rayscope::viewer {

void FrameTimes::add(double seconds) {
    if (seconds_.size() == kMaxCount) seconds_.erase(seconds_.begin());
    seconds_.push_back(static_cast<float>(seconds));
}

double FrameTimes::quantile(double fraction) const {
    if (seconds_.empty()) return 0.0;
    std::vector<float> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    const auto last = static_cast<double>(sorted.size() - 1);
    return static_cast<double>(sorted[static_cast<std::size_t>(std::round(fraction * last))]);
}

}  // namespace rayscope::viewer
