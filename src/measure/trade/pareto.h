#pragma once
#include <rayscope/trade.h>

namespace rayscope::measure {

/// Fills `onParetoFront` and `dominatedBy` of each point, and returns the front from fast to accurate. A
/// point is on the front if no other is both faster and more accurate. It is dominated only if another is
/// significantly better: faster and more accurate with disjoint intervals, or faster with the identical
/// picture; in both cases by more than `noise`, the relative timing noise of the machine (0.1 is 10 %).
std::vector<std::size_t> markParetoFront(std::vector<TradePoint>& points, double noise = 0.0);

/// Time of the point beyond that of the front at the same error, relative to the latter. The front is
/// interpolated on logarithmic axes. 0 on the front, and for points more accurate than all of it.
double excessOverParetoFront(const std::vector<TradePoint>& points, const std::vector<std::size_t>& front,
                             const TradePoint& point);

/// The most accurate point of the front for each of six budgets, in equal ratios from its fastest to its most
/// accurate point; equal ones once.
std::vector<TradeAdvice> adviceFrom(const std::vector<TradePoint>& points,
                                    const std::vector<std::size_t>& front);

}  // namespace rayscope::measure
