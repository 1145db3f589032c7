#pragma once
#include <rayscope/trade.h>
#include <string>
#include <string_view>

namespace rayscope::measure {

/// Text that means itself in HTML and SVG.
std::string escaped(std::string_view text);

/// "0.0123", "1.2e-5", "12 s": short enough for a table, exact enough to tell neighbours apart.
std::string shortNumber(double value);

/// A chart with logarithmic axes as an inline SVG element; colours are classes of the page's style sheet.
/// Values must be positive; others are not drawn.
class LogChart {
  public:
    struct Range {
        double lower, upper;
    };
    LogChart(int width, int height, Range x, Range y, std::string xTitle, std::string yTitle);

    /// A mark with bars of its intervals; `tip` is shown when the pointer rests on it.
    void mark(const Interval& x, const Interval& y, std::string_view cssClass, const std::string& tip,
              double radius = 4);
    void line(const std::vector<std::pair<double, double>>& points, std::string_view cssClass);
    void label(double x, double y, const std::string& text);
    std::string svg() const;

  private:
    double px(double x) const;
    double py(double y) const;
    void drawAxes();

    int width_, height_;
    Range x_, y_;
    std::string xTitle_, yTitle_, body_;
};

/// The range of positive values with a margin of a few per cent on a logarithmic axis.
LogChart::Range rangeOf(const std::vector<double>& values);

}  // namespace rayscope::measure
