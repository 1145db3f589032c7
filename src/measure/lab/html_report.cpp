// The result of the laboratory for people: one page that needs no other file.
#include <fmt/format.h>

#include <rayscope/lab.h>
#include <algorithm>
#include <cmath>

#include "embedded_report.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope {

namespace {

/// Classes of the style sheet: the front is Rayscope, the others are alternatives.
constexpr const char* kClasses[] = {"front", "knob", "yours", "feature"};

const char* classOf(LabMethod method) { return kClasses[static_cast<int>(method)]; }

using Share = double (*)(const LabCounts&);

double share(std::uint64_t part, std::uint64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);  // NaN: no ray could be tried
}
double leakShare(const LabCounts& c) { return share(c.leaks, c.sharedEdgeRays); }
double doubleShare(const LabCounts& c) { return share(c.doubleHits, c.sharedEdgeRays); }
double falseShare(const LabCounts& c) { return share(c.falseHits, c.spawned); }
double lostShare(const LabCounts& c) { return share(c.missedSurfaces, c.offsetSurfaceRays); }
double errorOf(const LabCounts& c) { return std::isfinite(c.tRatio) ? c.tRatio : 1e30; }

std::string percent(double x) {
    if (x == 0.0) return "0";
    return x < 0.001 ? fmt::format("{:.2g} ‰", 1000.0 * x) : fmt::format("{:.3g} %", 100.0 * x);
}

/// Green for nothing, then the redder the more.
std::string cellColor(double x) {
    if (x == 0.0) return "hsl(140 45% 45% / 0.25)";
    const double strength = std::clamp(1.0 + std::log10(x) / 4.0, 0.15, 1.0);
    return fmt::format("hsl(5 75% 50% / {:.2f})", 0.2 + 0.6 * strength);
}

std::vector<double> offsetsOf(const LabResult& r) {
    std::vector<double> offsets;
    for (const LabTestPoint& testPoint : r.testPoints) offsets.push_back(testPoint.transform.offset);
    std::sort(offsets.begin(), offsets.end());
    offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    return offsets;
}

std::vector<int> scalesOf(const LabResult& r) {
    std::vector<int> scales;
    for (const LabTestPoint& testPoint : r.testPoints)
        if (scales.empty() || scales.back() != testPoint.transform.scale)
            scales.push_back(testPoint.transform.scale);
    return scales;
}

const LabTestPoint* cellAt(const LabResult& r, int scale, double offset) {
    for (const LabTestPoint& testPoint : r.testPoints)
        if (testPoint.transform.scale == scale && testPoint.transform.offset == offset) return &testPoint;
    return nullptr;
}

/// Scales down, offsets to the right; a testPoint says and shows the share of rays that went wrong.
std::string map(const LabResult& r, LabMethod method, Share value, const char* title) {
    std::string table = fmt::format("<div class='card'><b>{}: {}</b><table><tr><th>scale</th>", title,
                                    measure::escaped(infoOf(method).label));
    const std::vector<double> offsets = offsetsOf(r);
    for (const double offset : offsets) table += fmt::format("<th class='n'>{:g}</th>", offset);
    table += "</tr>\n";
    for (const int scale : scalesOf(r)) {
        table += fmt::format("<tr><td>2<sup>{}</sup></td>", scale);
        for (const double offset : offsets) {
            const LabTestPoint* testPoint = cellAt(r, scale, offset);
            const double x = testPoint ? value(testPoint->of(method)) : 0.0;
            table += testPoint ? fmt::format("<td class='n' style='background:{}'>{}</td>", cellColor(x),
                                             percent(x))
                               : std::string("<td class='n soft'>–</td>");
        }
        table += "</tr>\n";
    }
    return table + "</table></div>\n";
}

/// Error over bound by offset, at the scale of the scene.
std::string errorChart(const LabResult& r) {
    std::vector<double> values{1.0};
    for (const LabTestPoint& testPoint : r.testPoints)
        for (const LabMethod method : kLabMethods)
            if (testPoint.transform.scale == 0) values.push_back(errorOf(testPoint.of(method)));
    measure::LogChart chart(1040, 380, {0.1, 2e7}, measure::rangeOf(values),
                            "offset in sizes (0 stands at 0.1)", "largest error of t / bound");
    chart.line({{0.1, 1.0}, {2e7, 1.0}}, "base");
    for (const LabMethod method : kLabMethods) {
        std::vector<std::pair<double, double>> line;
        for (const LabTestPoint& testPoint : r.testPoints) {
            if (testPoint.transform.scale != 0) continue;
            const double x = std::max(testPoint.transform.offset, 0.1), y = errorOf(testPoint.of(method));
            line.emplace_back(x, y);
            chart.mark({x, x, x}, {y, y, y}, classOf(method),
                       fmt::format("{}\noffset {:g} sizes\nerror / bound {}", infoOf(method).label,
                                   testPoint.transform.offset, measure::shortNumber(y)));
        }
        chart.line(line, classOf(method));
    }
    std::string legend = "<p class='legend soft'>";
    for (const LabMethod method : kLabMethods)
        legend += fmt::format("<span class='{}'><i></i>{}</span>", classOf(method),
                              measure::escaped(infoOf(method).label));
    return "<div class='card'>" + chart.svg() + legend + "</p></div>\n";
}

std::string fact(const std::string& value, const std::string& what) {
    return fmt::format("<div class='fact'><b>{}</b><span>{}</span></div>\n", value, what);
}

std::string header(const LabResult& r) {
    const LabRange& safe = r.range(LabMethod::Rayscope);
    std::string page = fmt::format(
        "<h1>Numbers at the extremes: {}</h1>\n<p class='soft'>{} triangles, {} shared edges, {} closed "
        "vertices. "
        "The mesh was scaled and moved through {} cells; in each, exact arithmetic on its floats says what "
        "{} rays "
        "have to hit.</p>\n<div class='facts'>\n",
        measure::escaped(r.scene), r.triangles, r.sharedEdges, r.closedVertices, r.testPoints.size(),
        r.raysPerTestPoint + r.raysPerTestPoint / 2);
    page += fact(fmt::format("2<sup>{}</sup> … 2<sup>{}</sup>", safe.lowestScale, safe.highestScale),
                 "scales without a fault");
    page += fact(fmt::format("{:g} sizes", safe.largestOffset), "largest offset without a fault");
    page +=
        fact(fmt::format("{:g} sizes", r.meshOffset), "largest offset at which the mesh keeps all triangles");
    page +=
        fact(fmt::format("{:.3g} / {:.3g}", r.size, r.offset), "size of the scene, and its offset in sizes");
    page += "</div>\n";
    for (const std::string& remark : r.remarks)
        page += fmt::format("<p class='warn'>{}</p>\n", measure::escaped(remark));
    return page;
}

std::string maps(const LabResult& r, Share value, const char* title, const char* words) {
    std::string page = fmt::format("<h2>{}</h2>\n<p>{}</p>\n", title, words);
    for (const LabMethod method : kLabMethods) page += map(r, method, value, title);
    return page;
}

}  // namespace

std::string labHtml(const LabResult& r) {
    std::string page =
        "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>Rayscope lab</title><style>\n";
    page += report::files()[0].content;
    page += "</style></head><body><main>\n" + header(r);
    page +=
        "<h2>Errors of t</h2>\n<p>Against exact rational arithmetic, over the bound that the tracer promises "
        "(src/bvh/intersect/hit_error.h). Below 1 the promise is kept.</p>\n" +
        errorChart(r);
    page += maps(r, leakShare, "Leaks",
                 "Rays at shared edges and vertices that hit none of the triangles around "
                 "them. Columns are offsets in sizes of the mesh; – where no ray could be aimed because the "
                 "mesh has collapsed.");
    page += maps(r, doubleShare, "Double hits",
                 "The same rays, if they cross an even number of those triangles.");
    page +=
        maps(r, falseShare, "False hits", "Rays that leave a surface and hit it, or what lies behind it.");
    page +=
        maps(r, lostShare, "Lost surfaces", "A second surface eight error bounds above the first, missed.");
    return page + "</main></body></html>\n";
}

}  // namespace rayscope
