#pragma once
#include <rayscope/trade.h>

#include "measure/trade/parameters.h"

namespace rayscope::measure {

/// What will be measured: the base, its control and what the caller added; then presets, effects and single
/// knobs from cheap to dear; then several knobs at once from cheap to dear. Cheap and dear go by samples
/// alone.
std::vector<TradePoint> candidatesFor(const SceneRequirements& scene, const Settings& base,
                                      const TradeRequest& request);

/// "spp 16, max_depth 2": in what `settings` differ from the base.
std::string differenceText(const Settings& base, const Settings& settings);

}  // namespace rayscope::measure
