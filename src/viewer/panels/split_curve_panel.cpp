#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/bvh_panels.h"
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

void drawPlot(const probe::SplitCurve& curve, Range range) {
    const float width = ImGui::GetContentRegionAvail().x, height = scaled(90.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ui::area("Split plot", {width, height});
    draw.AddRectFilled(at, {at.x + width, at.y + height}, IM_COL32(20, 22, 26, 255));
    const double span = std::max(range.high - range.low, 1e-12);
    const auto yOf = [&](double cost) {
        return at.y + height * static_cast<float>(0.95 - 0.9 * (cost - range.low) / span);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& planes = curve.axes[axis];
        const auto xOf = [&](std::size_t i) {
            return at.x + width * (static_cast<float>(i) + 1.0f) / (static_cast<float>(planes.size()) + 1.0f);
        };
        for (std::size_t i = 0; i + 1 < planes.size(); ++i)
            if (!std::isnan(planes[i].cost) && !std::isnan(planes[i + 1].cost))
                draw.AddLine({xOf(i), yOf(planes[i].cost)}, {xOf(i + 1), yOf(planes[i + 1].cost)},
                             kAxisColors[axis], scaled(1.5f));
        if (planes.size() == 1 && !std::isnan(planes[0].cost))
            draw.AddCircleFilled({xOf(0), yOf(planes[0].cost)}, scaled(3.0f), kAxisColors[axis]);
    }
    if (!std::isnan(curve.actualCost))
        for (float x = 0.0f; x < width; x += scaled(8.0f))
            draw.AddLine({at.x + x, yOf(curve.actualCost)},
                         {at.x + std::min(x + scaled(4.0f), width), yOf(curve.actualCost)},
                         IM_COL32(240, 242, 245, 255), scaled(1.0f));
    tooltip(
        "SAH cost of the node over the split planes between bins, from left to right along each axis; lower "
        "is better. Dashed: the split of this tree.");
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
    ImGui::SameLine(0.0f, scaled(14.0f));
    dimText(fmt::format("from {:.4g} to {:.4g}", range.low, range.high));
    valueRow("Split of this tree",
             std::isnan(curve.actualCost) ? "none (leaf)" : fmt::format("{:.5g}", curve.actualCost));
    valueRow("As a leaf", fmt::format("{:.5g}", curve.leafCost));
}

}  // namespace rayscope::viewer
