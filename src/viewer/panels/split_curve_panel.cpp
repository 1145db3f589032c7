#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/plot.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr ImU32 kAxisColors[] = {IM_COL32(86, 180, 233, 255), IM_COL32(230, 159, 0, 255),
                                 IM_COL32(204, 121, 167, 255)};
constexpr const char* kAxisNames[] = {"x", "y", "z"};

struct Range {
    double low, high;
};

/// Without the cost of a leaf, which may be far above those of the splits.
Range rangeOf(const probe::SplitCurve& curve) {
    Range range{INFINITY, -INFINITY};
    const auto include = [&](double cost) {
        if (std::isnan(cost)) return;
        range = {std::min(range.low, cost), std::max(range.high, cost)};
    };
    for (const auto& planes : curve.axes)
        for (const probe::SplitCurve::Plane& plane : planes) include(plane.cost);
    include(curve.actualCost);
    return range;
}

void drawAxisCurve(const Plot& plot, const std::vector<probe::SplitCurve::Plane>& planes, ImU32 color) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto at = [&](std::size_t i) {
        return plot.position(static_cast<double>(i) + 1.0, planes[i].cost);
    };
    for (std::size_t i = 0; i + 1 < planes.size(); ++i)
        if (!std::isnan(planes[i].cost) && !std::isnan(planes[i + 1].cost))
            draw.AddLine(at(i), at(i + 1), color, scaled(1.5f));
    if (planes.size() == 1 && !std::isnan(planes[0].cost)) draw.AddCircleFilled(at(0), scaled(3.0f), color);
}

/// The costs of the split plane under the cursor.
std::string costsAt(const probe::SplitCurve& curve, double plane) {
    const auto index = static_cast<std::size_t>(std::max(0.0, std::round(plane) - 1.0));
    std::string costs = fmt::format("split plane {}", index + 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (index < curve.axes[axis].size() && !std::isnan(curve.axes[axis][index].cost))
            costs += fmt::format("\n{}: SAH cost {:.5g}", kAxisNames[axis], curve.axes[axis][index].cost);
    return costs;
}

void drawPlot(const probe::SplitCurve& curve, Range range) {
    std::size_t planes = 1;
    for (const auto& axis : curve.axes) planes = std::max(planes, axis.size());
    const double margin = std::max(0.05 * (range.high - range.low), 1e-12);
    const Plot plot("Split plot", scaled(150.0f),
                    {0.0, static_cast<double>(planes) + 1.0, false, "split plane"},
                    {range.low - margin, range.high + margin, false, "SAH cost of the node"});
    for (std::size_t axis = 0; axis < 3; ++axis) drawAxisCurve(plot, curve.axes[axis], kAxisColors[axis]);
    if (!std::isnan(curve.actualCost)) {
        const float y = plot.position(0.0, curve.actualCost).y, right = plot.lower().x + plot.size().x;
        for (float x = plot.lower().x; x < right; x += scaled(8.0f))
            ImGui::GetWindowDrawList()->AddLine({x, y}, {std::min(x + scaled(4.0f), right), y},
                                                IM_COL32(240, 242, 245, 255), scaled(1.0f));
    }
    if (plot.hovered())
        showTooltip(costsAt(curve, plot.xAtCursor()) + "\nLower is better. Dashed: the split of this tree.");
}

}  // namespace

void drawSplitCurve(BvhInspector& bvh, int bins) {
    const probe::SplitCurve* known = bvh.curve(bins);
    if (known == nullptr) return dimText("computing ...");
    const probe::SplitCurve& curve = *known;
    const Range range = rangeOf(curve);
    dimText(fmt::format("{}: {} primitives, {} bins per axis",
                        bvh.shown.node == bvh::kNoNode ? "root" : fmt::format("node {}", bvh.shown.node),
                        curve.primitives, bins));
    if (!(range.low <= range.high)) return dimText("No split plane separates the primitives.");
    drawPlot(curve, range);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis > 0) ImGui::SameLine(0.0f, scaled(14.0f));
        ImGui::PushStyleColor(ImGuiCol_Text, kAxisColors[axis]);
        text(kAxisNames[axis]);
        ImGui::PopStyleColor();
    }
    valueRow("Split of this tree",
             std::isnan(curve.actualCost) ? "none (leaf)" : fmt::format("{:.5g}", curve.actualCost));
    valueRow("As a leaf", fmt::format("{:.5g}", curve.leafCost));
}

}  // namespace rayscope::viewer
