// Error over time of measured settings, their Pareto front, and the position of the current settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/panels.h"
#include "viewer/panels/plot.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr ImU32 kFront = IM_COL32(86, 180, 233, 255), kOther = IM_COL32(120, 124, 132, 150),
                kPreset = IM_COL32(230, 159, 0, 255), kHere = IM_COL32(240, 242, 245, 255);

void drawStart(Workspace& workspace, TradeJob& trade) {
    if (trade.busy()) {
        if (stoppableProgress(trade.fraction())) trade.stop();
        return;
    }
    if (ui::button("Measure quality and speed", {-1.0f, 0.0f}))
        trade.start(workspace.edit, workspace.viewSize, workspace.render.threads());
    tooltip(
        "Renders a small picture of this view with many settings, several times each, and measures the error "
        "against a reference image. 'rayscope trade' does the same and writes a report.");
    labelledRow("Time budget", false, "More time measures more settings, with narrower intervals.");
    ui::sliderFloat("##budget", &trade.budget, 2.0f, 600.0f, "%.0f s",
                    ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

bool isDrawn(const TradePoint& p) {
    return p.runs > 0 && p.role != TradeRole::Control && p.role != TradeRole::Effect &&
           p.seconds.value > 0.0 && p.error.value > 0.0;
}

/// All drawn points with a margin; both axes are logarithmic.
PlotAxis axisOf(const TradeResult& result, Interval TradePoint::*quantity, const char* title) {
    constexpr double kMargin = 1.25;
    double low = INFINITY, high = 0.0;
    for (const TradePoint& p : result.points) {
        if (!isDrawn(p)) continue;
        low = std::min(low, (p.*quantity).value);
        high = std::max(high, (p.*quantity).value);
    }
    if (!(low <= high)) return {1.0, 10.0, true, title};
    return {low / kMargin, high * kMargin, true, title};
}

ImVec2 positionOf(const Plot& plot, const TradePoint& p) {
    return plot.position(p.seconds.value, p.error.value);
}

/// The point under the cursor; null if there is none.
const TradePoint* pointAtCursor(const TradeResult& result, const Plot& plot) {
    const ImVec2 cursor = ImGui::GetMousePos();
    const TradePoint* nearest = nullptr;
    float distance = scaled(8.0f);
    for (const TradePoint& p : result.points) {
        if (!isDrawn(p)) continue;
        const ImVec2 at = positionOf(plot, p);
        const float away = std::hypot(at.x - cursor.x, at.y - cursor.y);
        if (away >= distance) continue;
        distance = away;
        nearest = &p;
    }
    return nearest;
}

std::string tooltipOf(const TradePoint* point) {
    if (point == nullptr)
        return "Each mark is a combination of settings: left is faster, down is more accurate. Blue: Pareto "
               "front. Orange: presets. Ring: the current settings. Click a mark to take its settings.";
    return fmt::format(
        "{}\n{:.3g} s [{:.3g}, {:.3g}]\nRMSE {:.3g} [{:.3g}, {:.3g}]{}\nClick to take these settings.",
        point->name, point->seconds.value, point->seconds.lower, point->seconds.upper, point->error.value,
        point->error.lower, point->error.upper,
        point->dominatedBy.empty() ? "" : "\ndominated by " + point->dominatedBy);
}

void drawMarks(const TradeResult& result, const Plot& plot, std::optional<std::size_t> here) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const TradePoint& p : result.points)
        if (isDrawn(p)) draw.AddCircleFilled(positionOf(plot, p), scaled(2.0f), kOther);
    for (std::size_t i = 0; i < result.paretoFront.size(); ++i) {
        const ImVec2 to = positionOf(plot, result.points[result.paretoFront[i]]);
        if (i > 0)
            draw.AddLine(positionOf(plot, result.points[result.paretoFront[i - 1]]), to, kFront,
                         scaled(1.5f));
        draw.AddCircleFilled(to, scaled(2.5f), kFront);
    }
    for (const TradePreset& d : result.presetPoints) {
        const ImVec2 to = positionOf(plot, result.points[d.point]);
        draw.AddCircleFilled(to, scaled(4.0f), kPreset);
        const float rightmost =
            plot.lower().x + plot.size().x - ImGui::CalcTextSize(d.preset.c_str()).x - scaled(2.0f);
        draw.AddText({std::min(to.x + scaled(6.0f), rightmost), to.y - scaled(17.0f)}, kPreset,
                     d.preset.c_str());
    }
    if (here) draw.AddCircle(positionOf(plot, result.points[*here]), scaled(7.0f), kHere, 0, scaled(2.0f));
}

/// Error over time; a click on a mark takes its settings.
void drawChart(const TradeResult& result, std::optional<std::size_t> here, Settings& settings) {
    const Plot plot("Chart", scaled(220.0f), axisOf(result, &TradePoint::seconds, "seconds"),
                    axisOf(result, &TradePoint::error, "RMSE of linear values"));
    drawMarks(result, plot, here);
    if (!plot.hovered()) return;
    const TradePoint* const point = pointAtCursor(result, plot);
    showTooltip(tooltipOf(point));
    if (point != nullptr && plot.clicked()) settings = point->settings;
}

void drawPosition(const TradeResult& result, std::optional<std::size_t> here) {
    labelledRow("Current settings", false, "Time and error, if these settings were measured.");
    if (!here) return dimText("not measured");
    const TradePoint& p = result.points[*here];
    text(fmt::format("{:.2g} s, error {:.2g}", p.seconds.value, p.error.value));
    valueRow("Distance to Pareto front",
             p.onParetoFront ? "0" : fmt::format("+{:.0f} % time", 100.0 * excessTime(result, *here)),
             "Extra time of these settings over the Pareto front at equal error.");
}

}  // namespace

void drawTradePanel(Workspace& workspace) {
    TradeJob& trade = workspace.trade;
    drawStart(workspace, trade);
    if (!trade.errorMessage().empty()) wrappedText(trade.errorMessage());
    const TradeResult* result = trade.result();
    if (!result) return;
    if (trade.scene() != workspace.edit.scene.get() || !(trade.camera() == workspace.edit.camera))
        dimText("Scene or camera changed since the measurement.");
    if (result->complete) {
        const std::optional<std::size_t> here = measuredPoint(*result, workspace.edit.settings);
        drawChart(*result, here, workspace.edit.settings);
        drawPosition(*result, here);
        dimText(fmt::format("{} x {} pixels, threads: {};\ntime differences below {:.0f} % are noise",
                            result->width, result->height, result->threads,
                            100.0 * result->smallestTimeDifference));
    }
    for (const std::string& remark : result->remarks) wrappedText(remark);
}

}  // namespace rayscope::viewer
