// A study as JSON and CSV, and the command-line arguments that reproduce its points. Keys and column names
// are an interface for scripts and older than the names of the members.
#include <fmt/format.h>

#include <rayscope/trade.h>
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/json_text.h"

namespace rayscope {

namespace {

constexpr const char* kRoles[] = {"base", "control", "yours", "knob", "joint", "feature", "preset", "extra"};

nlohmann::json toJson(const Interval& i) {
    return {{"value", i.value}, {"lower", i.lower}, {"upper", i.upper}};
}

nlohmann::json toJson(const TradeResult& result, const TradePoint& p) {
    nlohmann::json settings = nlohmann::json::object();
    for (const std::string_view key : settingKeys()) settings[std::string(key)] = textOf(p.settings, key);
    return {{"name", p.name},
            {"role", kRoles[static_cast<int>(p.role)]},
            {"knob", p.parameter},
            {"level", p.level},
            {"runs", p.runs},
            {"samples", p.work.samples},
            {"rays", p.work.rays},
            {"nodes_per_ray", p.work.nodesPerRay},
            {"tests_per_ray", p.work.testsPerRay},
            {"seconds", toJson(p.seconds)},
            {"build_seconds", toJson(p.buildSeconds)},
            {"rmse", toJson(p.error)},
            {"noise", toJson(p.noise)},
            {"bias", toJson(p.bias)},
            {"flip", toJson(p.flip)},
            {"time_ratio", toJson(p.timeRatio)},
            {"efficiency_ratio", toJson(p.efficiency)},
            {"next_seconds", toJson(p.predictedSeconds)},
            {"next_rmse", toJson(p.predictedError)},
            {"judged", p.reliable},
            {"biased", p.biased},
            {"same_picture", p.samePicture},
            {"on_front", p.onParetoFront},
            {"dominated_by", p.dominatedBy.empty() ? nlohmann::json(nullptr) : nlohmann::json(p.dominatedBy)},
            {"arguments", renderArguments(result, p)},
            {"settings", settings}};
}

nlohmann::json toJson(const TradeReference& r) {
    nlohmann::json history = nlohmann::json::array();
    for (const auto& [samples, error] : r.history) history.push_back({{"samples", samples}, {"rmse", error}});
    return {{"samples_per_half", r.samples},
            {"rmse", r.error},
            {"seconds", r.seconds},
            {"from_cache", r.fromCache},
            {"converges", r.converges},
            {"non_finite_pixels", r.nonFinitePixels},
            {"history", history}};
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

}  // namespace

std::string renderArguments(const TradeResult& result, const TradePoint& point) {
    std::string arguments = fmt::format("--size {}x{}", result.width, result.height);
    const Settings defaults;
    for (const std::string_view key : settingKeys()) {
        const std::string value = textOf(point.settings, key);
        const auto& idle = result.inactiveSettings;
        if (std::find(idle.begin(), idle.end(), key) != idle.end()) continue;
        if (value == textOf(defaults, key) && value == textOf(result.userSettings, key)) continue;
        arguments += fmt::format(" --set {}={}", key, value);
    }
    return arguments;
}

std::string tradeJson(const TradeResult& result) {
    nlohmann::json points = nlohmann::json::array(), front = nlohmann::json::array(), advice = front,
                   needs = front, evens = front, presetPoints = front;
    for (const TradePoint& p : result.points)
        if (p.runs > 0) points.push_back(toJson(result, p));
    const auto nameOf = [&](std::size_t i) { return result.points[i].name; };
    for (const std::size_t i : result.paretoFront) front.push_back(nameOf(i));
    for (const TradeAdvice& a : result.advice)
        advice.push_back({{"seconds", a.budgetSeconds},
                          {"point", nameOf(a.point)},
                          {"arguments", renderArguments(result, result.points[a.point])}});
    for (const TradeEffect& n : result.effects)
        needs.push_back({{"setting", n.key}, {"on", n.on}, {"proof", n.reason}, {"point", nameOf(n.point)}});
    for (const TradePreset& d : result.presetPoints)
        presetPoints.push_back({{"preset", d.preset}, {"point", nameOf(d.point)}, {"excess_time", d.excess}});
    for (const TradeBreakEven& b : result.breakEvens)
        evens.push_back({{"point", nameOf(b.point)}, {"rays", toJson(b.rays)}, {"words", b.text}});
    const nlohmann::json all = {{"scene", result.scene},
                                {"width", result.width},
                                {"height", result.height},
                                {"threads", result.threads},
                                {"blocks", result.blocks},
                                {"budget_seconds", result.budgetSeconds},
                                {"spent_seconds", result.spentSeconds},
                                {"complete", result.complete},
                                {"interrupted", result.interrupted},
                                {"reference", toJson(result.reference)},
                                {"smallest_time_difference", result.smallestTimeDifference},
                                {"convergence_slope", toJson(result.convergenceSlope)},
                                {"points", points},
                                {"front", front},
                                {"advice", advice},
                                {"needs", needs},
                                {"dial", presetPoints},
                                {"break_evens", evens},
                                {"not_measured", result.notMeasured},
                                {"remarks", result.remarks}};
    return base::jsonText(all, 1);
}

std::string tradeCsv(const TradeResult& result) {
    std::string table =
        "name,role,knob,level,runs,samples,rays,nodes_per_ray,tests_per_ray,seconds,seconds_lower,seconds_"
        "upper,rmse,rmse_lower,rmse_upper,noise,"
        "noise_lower,"
        "noise_upper,bias,bias_lower,bias_upper,flip,flip_lower,flip_upper,time_ratio,time_ratio_lower,time_"
        "ratio_upper,"
        "efficiency_ratio,efficiency_ratio_lower,efficiency_ratio_upper,build_seconds,build_seconds_lower,"
        "build_seconds_upper,judged,biased,same_picture,on_front,dominated_by\n";
    for (const TradePoint& p : result.points) {
        if (p.runs == 0) continue;
        table += fmt::format("{},{},{},{},{},{},{},{:.6g},{:.6g}", quoted(p.name),
                             kRoles[static_cast<int>(p.role)], p.parameter, p.level, p.runs, p.work.samples,
                             p.work.rays, p.work.nodesPerRay, p.work.testsPerRay);
        for (const Interval* i :
             {&p.seconds, &p.error, &p.noise, &p.bias, &p.flip, &p.timeRatio, &p.efficiency, &p.buildSeconds})
            table += fmt::format(",{:.6g},{:.6g},{:.6g}", i->value, i->lower, i->upper);
        table += fmt::format(",{:d},{:d},{:d},{:d},{}\n", p.reliable, p.biased, p.samePicture,
                             p.onParetoFront, p.dominatedBy.empty() ? "" : quoted(p.dominatedBy));
    }
    return table;
}

}  // namespace rayscope
