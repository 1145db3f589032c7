#include "measure/error_slope.h"

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"

namespace rayscope {

double errorSlope(const ErrorLooks& looks, ErrorMetric metric) {
    std::vector<double> x, y;
    for (std::size_t i = looks.size() > 4 ? looks.size() - 4 : 0; i < looks.size(); ++i) {
        if (looks[i].second.upper <= 0.0) continue;
        x.push_back(std::log(looks[i].first));
        y.push_back(std::log(looks[i].second.upper));
    }
    if (x.size() < 2) return 0.5;
    const double power = metric == ErrorMetric::RelMse ? 0.5 : 1.0;
    return std::clamp(-power * slopeOf(x, y), 0.4, 1.0);
}

}  // namespace rayscope
