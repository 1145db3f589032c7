// The result of a measurement for people: one page that needs no other file.
#include <fmt/format.h>

#include <rayscope/trade.h>
#include <algorithm>
#include <cmath>
#include <map>

#include "embedded_report.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope {

namespace {

/// The style sheet beside this file.
std::string_view styleSheet() { return report::files()[0].content; }

std::string withInterval(const Interval& i, const char* unit = "") {
    return fmt::format("{}{} <span class='soft'>[{}, {}]</span>", measure::shortNumber(i.value), unit,
                       measure::shortNumber(i.lower), measure::shortNumber(i.upper));
}

const char* classOf(const TradePoint& p) {
    if (p.onParetoFront) return "front";
    constexpr const char* classes[] = {"base",  "base",    "yours",  "knob",
                                       "joint", "feature", "preset", "extra"};
    return classes[static_cast<int>(p.role)];
}

std::string markClass(const TradePoint& p) { return std::string(classOf(p)) + (p.reliable ? "" : " hollow"); }

std::string tipOf(const TradePoint& p) {
    return fmt::format("{}\n{} s [{}, {}]\nRMSE {} [{}, {}]\n{} runs{}", p.name,
                       measure::shortNumber(p.seconds.value), measure::shortNumber(p.seconds.lower),
                       measure::shortNumber(p.seconds.upper), measure::shortNumber(p.error.value),
                       measure::shortNumber(p.error.lower), measure::shortNumber(p.error.upper), p.runs,
                       p.dominatedBy.empty() ? "" : "\ndominated by " + p.dominatedBy);
}

std::string fact(const std::string& value, const std::string& what) {
    return fmt::format("<div class='fact'><b>{}</b><span>{}</span></div>\n", value, what);
}

std::string header(const TradeResult& r) {
    std::string page = fmt::format(
        "<h1>Speed against accuracy: {}</h1>\n<p class='soft'>{} × {} pixels, {} threads, "
        "{} blocks of interleaved runs in {:.0f} s. All intervals are 95 %.</p>\n",
        measure::escaped(r.scene), r.width, r.height, r.threads, r.blocks, r.spentSeconds);
    const auto measured =
        std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return p.runs > 0; });
    const auto dominated =
        std::count_if(r.points.begin(), r.points.end(), [](const auto& p) { return !p.dominatedBy.empty(); });
    page += "<div class='facts'>\n" + fact(std::to_string(measured), "settings measured");
    page += fact(std::to_string(r.front.size()), "on the front") +
            fact(std::to_string(dominated), "dominated beyond doubt");
    page += fact(measure::shortNumber(r.reference.error),
                 fmt::format("RMSE of the reference, 2 × {} samples{}", r.reference.samples,
                             r.reference.fromCache ? ", some from the cache" : ""));
    page += fact(fmt::format("± {:.1f} %", 100.0 * r.smallestRatio), "noise of the machine in time");
    if (r.slope.value != 0.0)
        page += fact(
            fmt::format("{:.2f}", r.slope.value),
            fmt::format("convergence: error ~ samples^slope [{:.2f}, {:.2f}]", r.slope.lower, r.slope.upper));
    page += "</div>\n";
    for (const std::string& remark : r.remarks)
        page += fmt::format("<p class='warn'>{}</p>\n", measure::escaped(remark));
    return page;
}

measure::LogChart::Range rangeOfPoints(const TradeResult& r, Interval TradePoint::*value) {
    std::vector<double> values;
    for (const TradePoint& p : r.points)
        if (p.runs > 0) values.push_back((p.*value).value);
    return measure::rangeOf(values);
}

std::string frontChart(const TradeResult& r) {
    measure::LogChart chart(1040, 520, rangeOfPoints(r, &TradePoint::seconds),
                            rangeOfPoints(r, &TradePoint::error), "seconds for the picture", "error (RMSE)");
    std::vector<std::pair<double, double>> line;
    for (const std::size_t i : r.front) line.emplace_back(r.points[i].seconds.value, r.points[i].error.value);
    for (const bool front : {false, true})
        for (const TradePoint& p : r.points)
            if (p.runs > 0 && p.role != TradeRole::Control && p.onParetoFront == front)
                chart.mark(p.seconds, p.error, markClass(p), tipOf(p), front ? 5 : 3.5);
    chart.line(line, "front");
    for (const TradeAdvice& a : r.advice)
        chart.label(r.points[a.point].seconds.value, r.points[a.point].error.value, r.points[a.point].name);
    return "<h2>The front</h2>\n<p>Every mark is a picture that was rendered several times. Down is more "
           "accurate, left is "
           "faster; nothing measured lies below the line. Hollow marks have an error below ten times that of "
           "the "
           "reference.</p>\n<div class='card'>" +
           chart.svg() +
           "<p class='legend soft'><span class='front'><i></i>front</span><span "
           "class='base'><i></i>base</span><span "
           "class='yours'><i></i>your settings, presets</span><span class='knob'><i></i>one knob "
           "turned</span><span "
           "class='joint'><i></i>several</span><span class='feature'><i></i>effect "
           "switched</span></p></div>\n";
}

std::string adviceTable(const TradeResult& r) {
    std::string table =
        "<h2>What to use</h2>\n<p>The best measured settings for a time, and the command that reproduces "
        "them; one more "
        "run will lie within the brackets (95 %).</p>\n<div class='card'><table><tr><th "
        "class='n'>for</th><th "
        "class='n'>seconds</th><th class='n'>RMSE</th><th class='n'>FLIP</th><th>command</th></tr>\n";
    for (const TradeAdvice& a : r.advice) {
        const TradePoint& p = r.points[a.point];
        table += fmt::format(
            "<tr><td class='n'>{} s</td><td class='n'>{}</td><td class='n'>{}</td><td class='n'>{}</td>"
            "<td><code>rayscope render {} {}</code></td></tr>\n",
            measure::shortNumber(a.budgetSeconds), withInterval(p.nextSeconds), withInterval(p.nextError),
            withInterval(p.flip), measure::escaped(r.scene), measure::escaped(renderArguments(r, p)));
    }
    return table + "</table></div>\n";
}

std::string dialTable(const TradeResult& r) {
    if (r.presetPoints.empty()) return "";
    std::string table =
        "<h2>The dial</h2>\n<p>The presets on this scene, and how much longer they take than the front needs "
        "for the same "
        "error.</p>\n<div class='card'><table><tr><th>preset</th><th class='n'>seconds</th><th "
        "class='n'>RMSE</th><th "
        "class='n'>behind the front</th></tr>\n";
    for (const TradePreset& d : r.presetPoints)
        table += fmt::format(
            "<tr><td>{}</td><td class='n'>{}</td><td class='n'>{}</td><td class='n'>{}</td></tr>\n",
            measure::escaped(d.preset), withInterval(r.points[d.point].seconds),
            withInterval(r.points[d.point].error), excessText(r, d));
    return table + "</table></div>\n";
}

std::string needRow(const TradeResult& r, const TradeEffect& n) {
    const TradePoint& p = r.points[n.point];
    std::string verdict;
    if (!n.reason.empty())
        verdict = fmt::format("<span class='good'>proof</span>: {}{}", measure::escaped(n.reason),
                              p.runs == 0     ? ""
                              : p.samePicture ? "; measured too: the same picture, bit for bit"
                                              : "; <b class='bad'>but the picture differs</b>");
    else if (p.runs == 0)
        verdict = "not measured: it did not fit into the budget";
    else if (p.samePicture)
        verdict = "measured: the same picture, bit for bit";
    else
        verdict = fmt::format("measured: switched {} the picture is off by {} (RMSE without noise)",
                              n.on ? "off" : "on", withInterval(p.bias));
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td class='n'>{}</td></tr>\n",
                       measure::escaped(n.label), n.on ? "on" : "off", verdict,
                       p.runs > 1 ? withInterval(p.timeRatio) : "–");
}

std::string needsTable(const TradeResult& r) {
    std::string table = fmt::format(
        "<h2>What this scene needs</h2>\n<p>Each effect switched over, against the base. A ratio of time "
        "within "
        "{:.3f} … {:.3f} cannot be told from the noise of the machine.</p>\n<div "
        "class='card'><table><tr><th>effect</th>"
        "<th>is</th><th>verdict</th><th class='n'>time ratio if switched</th></tr>\n",
        1.0 / (1.0 + r.smallestRatio), 1.0 + r.smallestRatio);
    for (const TradeEffect& n : r.needs) table += needRow(r, n);
    return table + "</table></div>\n";
}

std::string knobChart(const TradeResult& r, const std::string& knob,
                      const std::vector<const TradePoint*>& points) {
    measure::LogChart chart(340, 250, rangeOfPoints(r, &TradePoint::seconds),
                            rangeOfPoints(r, &TradePoint::error), "seconds", "RMSE");
    std::vector<std::pair<double, double>> front, line;
    for (const std::size_t i : r.front)
        front.emplace_back(r.points[i].seconds.value, r.points[i].error.value);
    chart.line(front, "truth");
    for (const TradePoint* p : points) line.emplace_back(p->seconds.value, p->error.value);
    std::sort(line.begin(), line.end());
    chart.line(line, "knob");
    for (const TradePoint* p : points) {
        chart.mark(p->seconds, p->error,
                   p->role == TradeRole::Base ? "base"
                   : p->reliable              ? "knob"
                                              : "knob hollow",
                   tipOf(*p), 3.5);
        chart.label(p->seconds.value, p->error.value,
                    p->role == TradeRole::Base ? textOf(p->settings, knob) : p->level);
    }
    return fmt::format("<div class='card'><h3>{}</h3>{}</div>\n", measure::escaped(knob), chart.svg());
}

std::string knobRows(const std::vector<const TradePoint*>& points) {
    std::string rows;
    for (const TradePoint* p : points) {
        if (p->role == TradeRole::Base) continue;
        std::string verdict = !p->dominatedBy.empty() ? "dominated by " + p->dominatedBy
                              : p->onParetoFront      ? "on the front"
                                                      : "";
        if (p->samePicture) verdict = "same picture" + (verdict.empty() ? "" : "; " + verdict);
        if (p->biased) verdict = "biased" + (verdict.empty() ? "" : "; " + verdict);
        rows += fmt::format("<tr><td>{} {}</td><td>{}</td>", measure::escaped(p->knob),
                            measure::escaped(p->level), measure::escaped(verdict));
        for (const Interval* i : {&p->timeRatio, &p->error, &p->noise, &p->bias, &p->efficiency})
            rows += fmt::format("<td class='n'>{}</td>", withInterval(*i));
        rows += "</tr>\n";
    }
    return rows;
}

std::string knobs(const TradeResult& r) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<const TradePoint*>> byKnob;
    for (const TradePoint& p : r.points) {
        if (p.role != TradeRole::Parameter || p.runs < 2) continue;
        if (!byKnob.contains(p.knob)) order.push_back(p.knob);
        byKnob[p.knob].push_back(&p);
    }
    std::string charts =
        "<h2>Knob by knob</h2>\n<p>One knob turned, everything else as in the base. The dashed line is "
        "the front. Knobs that leave the picture as it is move along the time only.</p>\n<div "
        "class='grid2'>\n";
    std::string rows;
    for (const std::string& knob : order) {
        byKnob[knob].push_back(&r.points.front());
        charts += knobChart(r, knob, byKnob[knob]);
        rows += knobRows(byKnob[knob]);
    }
    return charts +
           "</div>\n<div class='card'><table><tr><th>setting</th><th></th><th class='n'>time / base</th><th "
           "class='n'>RMSE"
           "</th><th class='n'>noise</th><th class='n'>bias</th><th class='n'>efficiency / base</th></tr>\n" +
           rows + "</table></div>\n";
}

std::string breakEvens(const TradeResult& r) {
    if (r.breakEvens.empty()) return "";
    std::string table = fmt::format(
        "<h2>Building against tracing</h2>\n<p>Against the base's hierarchy, which takes {} s to build. One "
        "picture of "
        "the base has {:.3g} rays.</p>\n<div class='card'><table><tr><th>setting</th><th class='n'>build, "
        "s</th><th>verdict</th></tr>\n",
        withInterval(r.points.front().buildSeconds), static_cast<double>(r.points.front().work.rays));
    for (const TradeBreakEven& b : r.breakEvens)
        table += fmt::format("<tr><td>{}</td><td class='n'>{}</td><td>{}</td></tr>\n",
                             measure::escaped(r.points[b.point].name),
                             withInterval(r.points[b.point].buildSeconds), measure::escaped(b.words));
    return table + "</table></div>\n";
}

std::string allPoints(const TradeResult& r) {
    std::string table =
        "<h2>All measurements</h2>\n<details><summary>Show</summary><div "
        "class='card'><table><tr><th>settings</th>"
        "<th class='n'>runs</th><th class='n'>samples</th><th class='n'>rays</th><th class='n'>boxes / "
        "ray</th>"
        "<th class='n'>tests / ray</th><th class='n'>seconds</th><th class='n'>RMSE</th><th "
        "class='n'>FLIP</th><th>dominated by</th></tr>\n";
    for (const TradePoint& p : r.points)
        if (p.runs > 0)
            table += fmt::format(
                "<tr><td class='{}'>{}</td><td class='n'>{}</td><td class='n'>{}</td><td class='n'>{}</td>"
                "<td class='n'>{:.2f}</td><td class='n'>{:.2f}</td><td class='n'>{}</td><td class='n'>{}</td>"
                "<td class='n'>{}</td><td>{}</td></tr>\n",
                classOf(p), measure::escaped(p.name), p.runs, p.work.samples, p.work.rays, p.work.nodesPerRay,
                p.work.testsPerRay, withInterval(p.seconds), withInterval(p.error), withInterval(p.flip),
                measure::escaped(p.dominatedBy));
    table += "</table></div></details>\n";
    if (!r.notMeasured.empty())
        table += fmt::format("<p class='soft'>{} more settings did not fit into the budget.</p>\n",
                             r.notMeasured.size());
    return table;
}

std::string method(const TradeResult& r) {
    return fmt::format(
        "<h2>How it was measured</h2>\n<p>The truth is the picture that your settings would give with "
        "samples and "
        "reflections without end: two independent halves of {} samples per pixel, whose difference says that "
        "their mean "
        "is off by {} (RMSE). Errors are products with both halves, so that the reference's own noise does "
        "not enter. "
        "Bias is what two runs with different seeds are wrong about together; the rest is noise. In each "
        "block every "
        "setting ran once, in random order, with the block's seed; times are medians, and ratios are formed "
        "within "
        "blocks. The base ran twice per block: what its two runs differ by is the noise of the "
        "machine.</p>\n",
        r.reference.samples, measure::shortNumber(r.reference.error));
}

}  // namespace

std::string tradeHtml(const TradeResult& result) {
    std::string page = fmt::format(
        "<!doctype html>\n<html lang='en'><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width'><title>Trade: {}</title>\n<style>{}</style>\n<main>\n",
        measure::escaped(result.scene), styleSheet());
    page += header(result);
    if (result.complete)
        page += frontChart(result) + adviceTable(result) + dialTable(result) + needsTable(result) +
                knobs(result) + breakEvens(result) + allPoints(result) + method(result);
    return page + "</main></html>\n";
}

}  // namespace rayscope
