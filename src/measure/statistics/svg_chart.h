#pragma once
#include <rayscope/interval.h>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::measure {

/// Text with special characters escaped for HTML and SVG.
std::string escaped(std::string_view text);

/// Three significant digits: "0.0123", "1.2e-05"; infinity as "∞".
std::string shortNumber(double value);

/// A chart with logarithmic axes as an inline SVG element, coloured by classes of the page's style sheet.
/// Values that are not positive are not drawn.
class LogChart {
  public:
    struct Range {
        double lower, upper;
    };
    LogChart(int width, int height, Range x, Range y, std::string xTitle, std::string yTitle);

    /// A mark with error bars; `tooltip` is shown under the pointer.
    void mark(const Interval& x, const Interval& y, std::string_view cssClass, const std::string& tooltip,
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

/// The range of the positive finite values with a margin of 5 % of its length on the logarithmic axis.
LogChart::Range rangeOf(const std::vector<double>& values);

}  // namespace rayscope::measure
