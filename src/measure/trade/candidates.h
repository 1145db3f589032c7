#pragma once
#include <rayscope/trade.h>

#include "measure/trade/parameters.h"

namespace rayscope::measure {

/// The candidates in the order of measurement: the base, its control and the extra ones of the request; then
/// presets, user settings, effects and single parameters by increasing cost; then combinations of parameters
/// by increasing cost. The cost is estimated from the sample counts.
std::vector<TradePoint> candidatesFor(const SceneRequirements& scene, const Settings& base,
                                      const TradeRequest& request);

/// The settings that differ from the base, as "spp 16, max_depth 2"; "base" if none does.
std::string differenceText(const Settings& base, const Settings& settings);

}  // namespace rayscope::measure
