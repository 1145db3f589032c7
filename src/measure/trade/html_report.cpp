// The HTML report of a study; its text is in report/trade.html.
#include <fmt/format.h>

#include <rayscope/trade.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/shell_quote.h"
#include "measure/report/report_template.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope {

namespace {

using measure::escaped;
using measure::shortNumber;

const measure::ReportTemplate& tradeParts() {
    static const measure::ReportTemplate embedded = measure::embeddedTemplate("trade.html");
    return embedded;
}

std::string withInterval(const Interval& i) {
    return tradeParts().fill(
        "interval",
        {{"value", shortNumber(i.value)}, {"lower", shortNumber(i.lower)}, {"upper", shortNumber(i.upper)}});
}

/// The class in report.css that colours a point.
const char* classOf(const TradePoint& p) {
    if (p.onParetoFront) return "front";
    constexpr const char* classes[] = {"base",        "base",   "user",   "parameter",
                                       "combination", "effect", "preset", "extra"};
    return classes[static_cast<int>(p.role)];
}

std::string markClass(const TradePoint& p) { return std::string(classOf(p)) + (p.reliable ? "" : " hollow"); }

std::string tooltipOf(const TradePoint& p) {
    return fmt::format("{}\n{} s [{}, {}]\nRMSE {} [{}, {}]\n{} runs{}", p.name, shortNumber(p.seconds.value),
                       shortNumber(p.seconds.lower), shortNumber(p.seconds.upper), shortNumber(p.error.value),
                       shortNumber(p.error.lower), shortNumber(p.error.upper), p.runs,
                       p.dominatedBy.empty() ? "" : "\ndominated by " + p.dominatedBy);
}

std::string facts(const TradeResult& r) {
    const auto measured =
        std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return p.runs > 0; });
    const auto dominated =
        std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return !p.dominatedBy.empty(); });
    std::string facts =
        measure::reportFact(std::to_string(measured), "candidates measured") +
        measure::reportFact(std::to_string(r.paretoFront.size()), "on the Pareto front") +
        measure::reportFact(std::to_string(dominated), "significantly dominated") +
        measure::reportFact(shortNumber(r.reference.error),
                            fmt::format("RMSE of the reference, 2 × {} samples{}", r.reference.samples,
                                        r.reference.fromCache ? ", partly from the cache" : "")) +
        measure::reportFact(fmt::format("± {:.1f} %", 100.0 * r.smallestTimeDifference),
                            "timing noise of the machine");
    const Interval& slope = r.convergenceSlope;
    if (slope.value != 0.0)
        facts += measure::reportFact(
            fmt::format("{:.2f}", slope.value),
            fmt::format("convergence: error ~ samples^slope [{:.2f}, {:.2f}]", slope.lower, slope.upper));
    return facts;
}

measure::LogChart::Range rangeOfPoints(const TradeResult& r, Interval TradePoint::*value) {
    std::vector<double> values;
    for (const TradePoint& p : r.points)
        if (p.runs > 0) values.push_back((p.*value).value);
    return measure::rangeOf(values);
}

std::vector<std::pair<double, double>> frontLine(const TradeResult& r) {
    std::vector<std::pair<double, double>> line;
    for (const std::size_t i : r.paretoFront)
        line.emplace_back(r.points[i].seconds.value, r.points[i].error.value);
    return line;
}

std::string paretoFront(const TradeResult& r) {
    measure::LogChart chart(1040, 520, rangeOfPoints(r, &TradePoint::seconds),
                            rangeOfPoints(r, &TradePoint::error), "seconds for the picture", "error (RMSE)");
    for (const bool front : {false, true})
        for (const TradePoint& p : r.points)
            if (p.runs > 0 && p.role != TradeRole::Control && p.onParetoFront == front)
                chart.mark(p.seconds, p.error, markClass(p), tooltipOf(p), front ? 5 : 3.5);
    chart.line(frontLine(r), "front");
    for (const TradeAdvice& a : r.advice)
        chart.label(r.points[a.point].seconds.value, r.points[a.point].error.value, r.points[a.point].name);
    return tradeParts().fill("pareto front", {{"chart", chart.svg()}});
}

std::string recommendations(const TradeResult& r) {
    std::string rows;
    for (const TradeAdvice& a : r.advice) {
        const TradePoint& p = r.points[a.point];
        rows += tradeParts().fill("recommendation", {{"budget", shortNumber(a.budgetSeconds)},
                                                     {"seconds", withInterval(p.predictedSeconds)},
                                                     {"error", withInterval(p.predictedError)},
                                                     {"flip", withInterval(p.flip)},
                                                     {"scene", escaped(base::shellQuotePath(r.scene))},
                                                     {"arguments", escaped(renderArguments(r, p))}}) +
                "\n";
    }
    return tradeParts().fill("recommendations", {{"rows", rows}});
}

std::string presetTable(const TradeResult& r) {
    std::string rows;
    for (const TradePreset& preset : r.presetPoints)
        rows += tradeParts().fill("preset", {{"preset", escaped(preset.preset)},
                                             {"seconds", withInterval(r.points[preset.point].seconds)},
                                             {"error", withInterval(r.points[preset.point].error)},
                                             {"excess", excessText(r, preset)}}) +
                "\n";
    return rows.empty() ? "" : tradeParts().fill("presets", {{"rows", rows}});
}

std::string effectResult(const TradeEffect& effect, const TradePoint& p) {
    if (!effect.reason.empty()) {
        const std::string check = p.runs == 0     ? ""
                                  : p.samePicture ? tradeParts().fill("effect check passed", {})
                                                  : tradeParts().fill("effect check failed", {});
        return tradeParts().fill("effect reason", {{"reason", escaped(effect.reason)}, {"check", check}});
    }
    if (p.runs == 0) return tradeParts().fill("effect not measured", {});
    if (p.samePicture) return tradeParts().fill("effect identical", {});
    return tradeParts().fill("effect error",
                             {{"state", effect.on ? "off" : "on"}, {"bias", withInterval(p.bias)}});
}

std::string effectTable(const TradeResult& r) {
    std::string rows;
    for (const TradeEffect& effect : r.effects) {
        const TradePoint& p = r.points[effect.point];
        rows += tradeParts().fill("effect", {{"label", escaped(effect.label)},
                                             {"state", effect.on ? "on" : "off"},
                                             {"result", effectResult(effect, p)},
                                             {"ratio", p.runs > 1 ? withInterval(p.timeRatio) : "–"}}) +
                "\n";
    }
    return tradeParts().fill("effects",
                             {{"lowest", fmt::format("{:.3f}", 1.0 / (1.0 + r.smallestTimeDifference))},
                              {"highest", fmt::format("{:.3f}", 1.0 + r.smallestTimeDifference)},
                              {"rows", rows}});
}

std::string parameterChart(const TradeResult& r, const std::string& key,
                           const std::vector<const TradePoint*>& points) {
    measure::LogChart chart(340, 250, rangeOfPoints(r, &TradePoint::seconds),
                            rangeOfPoints(r, &TradePoint::error), "seconds", "RMSE");
    chart.line(frontLine(r), "background");
    std::vector<std::pair<double, double>> line;
    line.reserve(points.size());
    for (const TradePoint* p : points) line.emplace_back(p->seconds.value, p->error.value);
    std::sort(line.begin(), line.end());
    chart.line(line, "parameter");
    for (const TradePoint* p : points) {
        const bool base = p->role == TradeRole::Base;
        const char* cssClass = base ? "base" : p->reliable ? "parameter" : "parameter hollow";
        chart.mark(p->seconds, p->error, cssClass, tooltipOf(*p), 3.5);
        chart.label(p->seconds.value, p->error.value, base ? textOf(p->settings, key) : p->level);
    }
    return tradeParts().fill("parameter chart", {{"parameter", escaped(key)}, {"chart", chart.svg()}}) + "\n";
}

std::string parameterRows(const std::vector<const TradePoint*>& points) {
    std::string rows;
    for (const TradePoint* p : points) {
        if (p->role == TradeRole::Base) continue;
        std::string result = !p->dominatedBy.empty() ? "dominated by " + p->dominatedBy
                             : p->onParetoFront      ? "on the Pareto front"
                                                     : "";
        if (p->samePicture) result.insert(0, result.empty() ? "identical picture" : "identical picture; ");
        if (p->biased) result.insert(0, result.empty() ? "biased" : "biased; ");
        rows += tradeParts().fill("parameter row", {{"parameter", escaped(p->parameter)},
                                                    {"level", escaped(p->level)},
                                                    {"result", escaped(result)},
                                                    {"ratio", withInterval(p->timeRatio)},
                                                    {"error", withInterval(p->error)},
                                                    {"noise", withInterval(p->noise)},
                                                    {"bias", withInterval(p->bias)},
                                                    {"efficiency", withInterval(p->efficiency)}}) +
                "\n";
    }
    return rows;
}

std::string parameterSection(const TradeResult& r) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<const TradePoint*>> byParameter;
    for (const TradePoint& p : r.points) {
        if (p.role != TradeRole::Parameter || p.runs < 2) continue;
        if (!byParameter.contains(p.parameter)) order.push_back(p.parameter);
        byParameter[p.parameter].push_back(&p);
    }
    std::string charts, rows;
    for (const std::string& key : order) {
        byParameter[key].push_back(&r.points.front());
        charts += parameterChart(r, key, byParameter[key]);
        rows += parameterRows(byParameter[key]);
    }
    return tradeParts().fill("parameters", {{"charts", charts}, {"rows", rows}});
}

std::string breakEvenTable(const TradeResult& r) {
    if (r.breakEvens.empty()) return "";
    std::string rows;
    for (const TradeBreakEven& b : r.breakEvens)
        rows += tradeParts().fill("break-even", {{"setting", escaped(r.points[b.point].name)},
                                                 {"seconds", withInterval(r.points[b.point].buildSeconds)},
                                                 {"result", escaped(b.text)}}) +
                "\n";
    return tradeParts().fill(
        "break-evens", {{"seconds", withInterval(r.points.front().buildSeconds)},
                        {"rays", fmt::format("{:.3g}", static_cast<double>(r.points.front().work.rays))},
                        {"rows", rows}});
}

std::string measurementTable(const TradeResult& r) {
    std::string rows;
    for (const TradePoint& p : r.points)
        if (p.runs > 0)
            rows += tradeParts().fill("measurement", {{"class", classOf(p)},
                                                      {"name", escaped(p.name)},
                                                      {"runs", std::to_string(p.runs)},
                                                      {"samples", std::to_string(p.work.samples)},
                                                      {"rays", std::to_string(p.work.rays)},
                                                      {"nodes", fmt::format("{:.2f}", p.work.nodesPerRay)},
                                                      {"tests", fmt::format("{:.2f}", p.work.testsPerRay)},
                                                      {"seconds", withInterval(p.seconds)},
                                                      {"error", withInterval(p.error)},
                                                      {"flip", withInterval(p.flip)},
                                                      {"dominated by", escaped(p.dominatedBy)}}) +
                    "\n";
    const std::string missing =
        r.notMeasured.empty()
            ? ""
            : tradeParts().fill("missing measurements", {{"count", std::to_string(r.notMeasured.size())}});
    return tradeParts().fill("measurements", {{"rows", rows}, {"missing", missing}});
}

std::string methodSection(const TradeResult& r) {
    return tradeParts().fill("method", {{"samples", std::to_string(r.reference.samples)},
                                        {"error", shortNumber(r.reference.error)}});
}

}  // namespace

std::string tradeHtml(const TradeResult& result) {
    std::string sections;
    if (result.complete)
        for (const auto& section : {paretoFront, recommendations, presetTable, effectTable, parameterSection,
                                    breakEvenTable, measurementTable, methodSection})
            if (const std::string html = section(result); !html.empty()) sections += html + "\n";
    return measure::reportPage(
        "Speed against accuracy: " + result.scene,
        tradeParts().fill("body", {{"scene", escaped(result.scene)},
                                   {"width", std::to_string(result.width)},
                                   {"height", std::to_string(result.height)},
                                   {"threads", std::to_string(result.threads)},
                                   {"blocks", std::to_string(result.blocks)},
                                   {"seconds", fmt::format("{:.0f}", result.spentSeconds)},
                                   {"facts", facts(result)},
                                   {"remarks", measure::reportRemarks(result.remarks)},
                                   {"sections", sections}}));
}

}  // namespace rayscope
