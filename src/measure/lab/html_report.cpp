// The HTML report of a robustness test; its text is in report/lab.html.
#include <fmt/format.h>

#include <rayscope/lab.h>
#include <algorithm>
#include <cmath>

#include "measure/report/report_template.h"
#include "measure/statistics/svg_chart.h"

namespace rayscope {

namespace {

using measure::escaped;

const measure::ReportTemplate& labParts() {
    static const measure::ReportTemplate embedded = measure::embeddedTemplate("lab.html");
    return embedded;
}

using Fraction = double (*)(const LabCounts&);

double fraction(std::uint64_t part, std::uint64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);  // NaN without rays: a gap in the map
}
double leakFraction(const LabCounts& c) { return fraction(c.leaks, c.sharedEdgeRays); }
double doubleHitFraction(const LabCounts& c) { return fraction(c.doubleHits, c.sharedEdgeRays); }
double falseHitFraction(const LabCounts& c) { return fraction(c.falseHits, c.spawned); }
double missedFraction(const LabCounts& c) { return fraction(c.missedSurfaces, c.offsetSurfaceRays); }
double errorOf(const LabCounts& c) { return std::isfinite(c.tRatio) ? c.tRatio : 1e30; }

std::string percent(double x) {
    if (x == 0.0) return "0";
    return x < 0.001 ? fmt::format("{:.2g} ‰", 1000.0 * x) : fmt::format("{:.3g} %", 100.0 * x);
}

/// Green for 0, then increasingly red on a logarithmic scale.
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

const LabTestPoint* testPointAt(const LabResult& r, int scale, double offset) {
    for (const LabTestPoint& testPoint : r.testPoints)
        if (testPoint.transform.scale == scale && testPoint.transform.offset == offset) return &testPoint;
    return nullptr;
}

std::string powerOfTwo(int exponent) {
    return labParts().fill("power of two", {{"exponent", std::to_string(exponent)}});
}

/// A table of one fraction over the test points: a row per scale, a column per offset.
std::string map(const LabResult& r, LabMethod method, Fraction value, const char* title) {
    const std::vector<double> offsets = offsetsOf(r);
    std::string heads, rows;
    for (const double offset : offsets)
        heads += labParts().fill("map offset", {{"offset", fmt::format("{:g}", offset)}});
    for (const int scale : scalesOf(r)) {
        std::string cells;
        for (const double offset : offsets) {
            const LabTestPoint* testPoint = testPointAt(r, scale, offset);
            const double x = testPoint ? value(testPoint->of(method)) : std::nan("");
            cells += std::isnan(x)
                         ? labParts().fill("map gap", {})
                         : labParts().fill("map cell", {{"color", cellColor(x)}, {"fraction", percent(x)}});
        }
        rows += labParts().fill("map row", {{"scale", powerOfTwo(scale)}, {"cells", cells}}) + "\n";
    }
    return labParts().fill(
        "map",
        {{"title", title}, {"method", escaped(infoOf(method).label)}, {"offsets", heads}, {"rows", rows}});
}

std::string maps(const LabResult& r, Fraction value, const char* title) {
    std::string all;
    for (const LabMethod method : kLabMethods) all += map(r, method, value, title) + "\n";
    return all;
}

/// Error over bound by offset, at scale 2^0. The classes of report.css are named as the methods.
std::string errorChart(const LabResult& r) {
    std::vector<double> values{1.0};
    for (const LabTestPoint& testPoint : r.testPoints)
        for (const LabMethod method : kLabMethods)
            if (testPoint.transform.scale == 0) values.push_back(errorOf(testPoint.of(method)));
    measure::LogChart chart(1040, 380, {0.1, 2e7}, measure::rangeOf(values),
                            "offset in sizes (0 is drawn at 0.1)", "largest error of t / bound");
    chart.line({{0.1, 1.0}, {2e7, 1.0}}, "base");
    for (const LabMethod method : kLabMethods) {
        std::vector<std::pair<double, double>> line;
        for (const LabTestPoint& testPoint : r.testPoints) {
            if (testPoint.transform.scale != 0) continue;
            const double x = std::max(testPoint.transform.offset, 0.1), y = errorOf(testPoint.of(method));
            line.emplace_back(x, y);
            chart.mark({x, x, x}, {y, y, y}, infoOf(method).name,
                       fmt::format("{}\noffset {:g} sizes\nerror / bound {}", infoOf(method).label,
                                   testPoint.transform.offset, measure::shortNumber(y)));
        }
        chart.line(line, infoOf(method).name);
    }
    return chart.svg();
}

std::string legend() {
    std::string entries;
    for (const LabMethod method : kLabMethods)
        entries += labParts().fill(
            "legend", {{"class", infoOf(method).name}, {"label", escaped(infoOf(method).label)}});
    return entries;
}

std::string facts(const LabResult& r) {
    const LabRange& range = r.range(LabMethod::Rayscope);
    return measure::reportFact(powerOfTwo(range.lowestScale) + " … " + powerOfTwo(range.highestScale),
                               "scales without a failure") +
           measure::reportFact(fmt::format("{:g} sizes", range.largestOffset),
                               "largest offset without a failure") +
           measure::reportFact(fmt::format("{:g} sizes", r.meshOffset),
                               "largest offset without degenerate triangles") +
           measure::reportFact(fmt::format("{:.3g} / {:.3g}", r.size, r.offset),
                               "size of the scene, and its offset in sizes");
}

}  // namespace

std::string labHtml(const LabResult& r) {
    return measure::reportPage(
        "Numerical robustness: " + r.scene,
        labParts().fill("body", {{"scene", escaped(r.scene)},
                                 {"triangles", std::to_string(r.triangles)},
                                 {"edges", std::to_string(r.sharedEdges)},
                                 {"vertices", std::to_string(r.closedVertices)},
                                 {"points", std::to_string(r.testPoints.size())},
                                 {"rays", std::to_string(r.raysPerTestPoint + r.raysPerTestPoint / 2)},
                                 {"facts", facts(r)},
                                 {"remarks", measure::reportRemarks(r.remarks)},
                                 {"chart", errorChart(r)},
                                 {"legend", legend()},
                                 {"leaks", maps(r, leakFraction, "Leaks")},
                                 {"double hits", maps(r, doubleHitFraction, "Double hits")},
                                 {"false hits", maps(r, falseHitFraction, "False hits")},
                                 {"lost surfaces", maps(r, missedFraction, "Lost surfaces")}}));
}

}  // namespace rayscope
