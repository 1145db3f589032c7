#pragma once
#include <imgui.h>
#include <vector>

namespace rayscope::viewer {

/// The values along one axis of a plot. A logarithmic axis needs 0 < low.
struct PlotAxis {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;
    const char* title = "";  ///< with the unit
};

/// Round numbers within the axis, at most `most`.
std::vector<double> plotTicks(const PlotAxis& axis, int most);

/// An area with labelled axes, as wide as the panel; what is drawn into it uses position().
class Plot {
  public:
    /// Draws axes, grid lines, numbers and titles. `height` includes them.
    Plot(const char* label, float height, const PlotAxis& x, const PlotAxis& y);

    ImVec2 position(double x, double y) const;
    /// The value at the cursor, within the axis.
    double xAtCursor() const;
    bool hovered() const { return hovered_; }
    bool clicked() const { return clicked_; }
    /// Of the area without numbers and titles.
    ImVec2 lower() const { return lower_; }
    ImVec2 size() const { return size_; }

  private:
    void drawAxes(float line) const;

    PlotAxis x_, y_;
    ImVec2 lower_, size_;
    bool hovered_ = false, clicked_ = false;
};

}  // namespace rayscope::viewer
