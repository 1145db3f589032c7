#include "measure/statistics/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/printable_text.h"

namespace rayscope::measure {

namespace {
constexpr int kLeft = 62, kRight = 16, kTop = 14, kBottom = 46;

/// 1, 2, 5 in each decade, or only 1 where there are many decades.
std::vector<double> ticksOf(const LogChart::Range& range) {
    const bool wide = range.upper / range.lower > 300.0;
    std::vector<double> ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(range.lower))); decade < 40; ++decade) {
        for (const double step : {1.0, 2.0, 5.0}) {
            const double value = step * std::pow(10.0, decade);
            if (value > range.upper) return ticks;
            if (value >= range.lower && (!wide || step == 1.0)) ticks.push_back(value);
        }
    }
    return ticks;
}
}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : base::validUtf8(text)) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\'')
            result += "&#39;";
        else
            result += c;
    }
    return result;
}

std::string shortNumber(double value) {
    if (std::isinf(value)) return value > 0.0 ? "∞" : "−∞";
    return fmt::format("{:.3g}", value);
}

LogChart::Range rangeOf(const std::vector<double>& values) {
    double lower = 1e300, upper = 0.0;
    for (const double value : values) {
        if (!(value > 0.0) || !std::isfinite(value)) continue;
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
    if (upper == 0.0) return {1.0, 10.0};
    const double margin = std::max(std::pow(upper / lower, 0.05), 1.15);
    return {lower / margin, upper * margin};
}

LogChart::LogChart(int width, int height, Range x, Range y, std::string xTitle, std::string yTitle)
    : width_(width), height_(height), x_(x), y_(y), xTitle_(std::move(xTitle)), yTitle_(std::move(yTitle)) {
    drawAxes();
}

double LogChart::px(double x) const {
    const double f = std::log(x / x_.lower) / std::log(x_.upper / x_.lower);
    return kLeft + std::clamp(f, 0.0, 1.0) * (width_ - kLeft - kRight);
}

double LogChart::py(double y) const {
    const double f = std::log(y / y_.lower) / std::log(y_.upper / y_.lower);
    return height_ - kBottom - std::clamp(f, 0.0, 1.0) * (height_ - kTop - kBottom);
}

void LogChart::drawAxes() {
    const int bottom = height_ - kBottom, right = width_ - kRight;
    for (const double tick : ticksOf(x_))
        body_ += fmt::format(
            "<line class='grid' x1='{0:.1f}' y1='{1}' x2='{0:.1f}' y2='{2}'/>"
            "<text x='{0:.1f}' y='{3}' text-anchor='middle'>{4}</text>\n",
            px(tick), kTop, bottom, bottom + 16, shortNumber(tick));
    for (const double tick : ticksOf(y_))
        body_ += fmt::format(
            "<line class='grid' x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}'/>"
            "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5}</text>\n",
            py(tick), kLeft, right, kLeft - 6, py(tick) + 4.0, shortNumber(tick));
    body_ += fmt::format("<text class='axis' x='{}' y='{}' text-anchor='middle'>{}</text>\n",
                         (kLeft + right) / 2, height_ - 8, escaped(xTitle_));
    body_ += fmt::format(
        "<text class='axis' transform='translate(14 {}) rotate(-90)' text-anchor='middle'>{}</text>\n",
        (kTop + bottom) / 2, escaped(yTitle_));
}

void LogChart::mark(const Interval& x, const Interval& y, std::string_view cssClass,
                    const std::string& tooltip, double radius) {
    if (!(x.value > 0.0) || !(y.value > 0.0)) return;
    const double cx = px(x.value), cy = py(y.value);
    const auto atLeast = [](double value, double lowest) { return std::max(value, lowest); };
    body_ += fmt::format(
        "<g class='mark {}'><title>{}</title><line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/>"
        "<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/><circle cx='{:.1f}' cy='{:.1f}' "
        "r='{}'/></g>\n",
        cssClass, escaped(tooltip), px(atLeast(x.lower, x_.lower)), cy, px(atLeast(x.upper, x_.lower)), cy,
        cx, py(atLeast(y.lower, y_.lower)), cx, py(atLeast(y.upper, y_.lower)), cx, cy, radius);
}

void LogChart::line(const std::vector<std::pair<double, double>>& points, std::string_view cssClass) {
    std::string path;
    for (const auto& [x, y] : points)
        if (x > 0.0 && y > 0.0) path += fmt::format("{:.1f},{:.1f} ", px(x), py(y));
    body_ += fmt::format("<polyline class='{}' points='{}'/>\n", cssClass, path);
}

void LogChart::label(double x, double y, const std::string& text) {
    const bool left = px(x) > width_ - 170;
    body_ += fmt::format("<text class='label' x='{:.1f}' y='{:.1f}' text-anchor='{}'>{}</text>\n",
                         px(x) + (left ? -8.0 : 8.0), py(y) - 7.0, left ? "end" : "start", escaped(text));
}

std::string LogChart::svg() const {
    return fmt::format("<svg viewBox='0 0 {} {}' role='img'>\n{}</svg>\n", width_, height_, body_);
}

}  // namespace rayscope::measure
