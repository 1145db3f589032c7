#include "measure/trade/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope::measure {

namespace {

/// Whether the point can be on the front. A switched effect changes the picture to be rendered, and a point
/// with the picture and the time of the base is no alternative to it.
bool isAlternative(const TradePoint& point) {
    const bool likeBase = point.samePicture && point.role != TradeRole::Base && point.timeRatio.contains(1.0);
    return point.runs >= 2 && !likeBase && point.role != TradeRole::Control &&
           point.role != TradeRole::Effect;
}

bool samePicture(const TradePoint& a, const TradePoint& b) {
    return (a.samePicture || a.role == TradeRole::Base) && (b.samePicture || b.role == TradeRole::Base);
}

bool isSignificantlyBetter(const TradePoint& a, const TradePoint& b, double noise) {
    return a.seconds.upper < b.seconds.lower && b.seconds.value > (1.0 + noise) * a.seconds.value &&
           (a.error.upper < b.error.lower || samePicture(a, b));
}

}  // namespace

std::vector<std::size_t> markParetoFront(std::vector<TradePoint>& points, double noise) {
    std::vector<std::size_t> order, front;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (isAlternative(points[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].seconds.value < points[b].seconds.value;
    });
    for (const std::size_t i : order) {
        TradePoint& point = points[i];
        point.onParetoFront = front.empty() || point.error.value < points[front.back()].error.value;
        if (point.onParetoFront) front.push_back(i);
        const TradePoint* best = nullptr;
        for (const std::size_t j : order)
            if (isSignificantlyBetter(points[j], point, noise) &&
                (!best || points[j].efficiency.value > best->efficiency.value))
                best = &points[j];
        point.dominatedBy = best ? best->name : "";
    }
    return front;
}

double excessOverParetoFront(const std::vector<TradePoint>& points, const std::vector<std::size_t>& front,
                             const TradePoint& point) {
    const double error = point.error.value;
    for (std::size_t k = 0; k < front.size(); ++k) {
        const TradePoint& next = points[front[k]];
        if (next.error.value > error) continue;
        double seconds = next.seconds.value;
        if (k > 0) {
            const TradePoint& last = points[front[k - 1]];
            const double f =
                std::log(error / last.error.value) / std::log(next.error.value / last.error.value);
            seconds = last.seconds.value * std::pow(next.seconds.value / last.seconds.value, f);
        }
        return std::max(0.0, point.seconds.value / seconds - 1.0);
    }
    return 0.0;
}

std::vector<TradeAdvice> adviceFrom(const std::vector<TradePoint>& points,
                                    const std::vector<std::size_t>& front) {
    std::vector<TradeAdvice> advice;
    if (front.empty()) return advice;
    const double least = points[front.front()].seconds.upper, most = points[front.back()].seconds.upper;
    constexpr int kSteps = 6;
    for (int step = 0; step < kSteps; ++step) {
        const double budget = least * std::pow(std::max(most / least, 1.0), step / (kSteps - 1.0));
        std::size_t best = front.front();
        for (const std::size_t i : front)
            if (points[i].seconds.upper <= budget * (1.0 + 1e-9) &&
                points[i].error.value < points[best].error.value)
                best = i;
        if (advice.empty() || advice.back().point != best)
            advice.push_back({points[best].seconds.upper, best});
    }
    return advice;
}

}  // namespace rayscope::measure

namespace rayscope {

double excessTime(const TradeResult& result, std::size_t point) {
    return measure::excessOverParetoFront(result.points, result.paretoFront, result.points[point]);
}

std::string excessText(const TradeResult& result, const TradePreset& preset) {
    const std::string percent = fmt::format("{:.0f} %", 100.0 * preset.excess);
    const bool significant = percent == "0 %" || !result.points[preset.point].dominatedBy.empty();
    return significant ? percent : percent + ", not significant";
}

std::optional<std::size_t> measuredPoint(const TradeResult& result, const Settings& settings) {
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const TradePoint& point = result.points[i];
        if (point.runs == 0 || point.role == TradeRole::Control) continue;
        Settings same = settings;
        for (const std::string& key : result.inactiveSettings) assign(same, key, textOf(point.settings, key));
        if (same.spp == point.settings.spp && changed(same, point.settings) <= Invalidates::Display) return i;
    }
    return std::nullopt;
}

}  // namespace rayscope
