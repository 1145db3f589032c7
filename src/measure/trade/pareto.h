#pragma once
#include <rayscope/trade.h>

namespace rayscope::measure {

/// Fills `onParetoFront` and `dominatedBy` of each point, and returns the front from fast to accurate. A
/// point is on the front if none is both faster and more accurate. It is dominated only beyond doubt: if
/// another is faster and more accurate with intervals that do not overlap, or faster with the same picture.
/// In both cases by more than `noise`, the least difference in time (0.1 is 10 %) that can be told from the
/// machine's.
std::vector<std::size_t> markParetoFront(std::vector<TradePoint>& points, double noise = 0.0);

/// How much longer the point takes than the front needs for its error, which is interpolated between points
/// of the front on logarithmic axes; 0 on the front, and where it has no part so accurate.
double excessOverParetoFront(const std::vector<TradePoint>& points, const std::vector<std::size_t>& front,
                             const TradePoint& point);

/// For times in equal ratios between both ends of the front: the most accurate point that needs no more.
std::vector<TradeAdvice> adviceFrom(const std::vector<TradePoint>& points,
                                    const std::vector<std::size_t>& front);

}  // namespace rayscope::measure
