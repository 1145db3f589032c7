// Error over time of measured settings, their Pareto front, and the position of the current settings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/panels.h"
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

/// Seconds to the right, errors upwards, both logarithmic.
class Chart {
  public:
    Chart(const TradeResult& result, ImVec2 at, ImVec2 size) : at_(at), size_(size) {
        for (const TradePoint& p : result.points) {
            if (!isDrawn(p)) continue;
            include(seconds_, p.seconds.value);
            include(error_, p.error.value);
        }
    }

    static bool isDrawn(const TradePoint& p) {
        return p.runs > 0 && p.role != TradeRole::Control && p.role != TradeRole::Effect &&
               p.seconds.value > 0.0 && p.error.value > 0.0;
    }
    ImVec2 position(const TradePoint& p) const {
        return {at_.x + size_.x * part(seconds_, p.seconds.value),
                at_.y + size_.y * (1.0f - part(error_, p.error.value))};
    }

  private:
    struct Span {
        double low = INFINITY, high = -INFINITY;
    };
    static void include(Span& span, double value) {
        span = {std::min(span.low, std::log(value)), std::max(span.high, std::log(value))};
    }
    static float part(const Span& span, double value) {
        return static_cast<float>(0.1 +
                                  0.8 * (std::log(value) - span.low) / std::max(span.high - span.low, 1e-9));
    }

    ImVec2 at_, size_;
    Span seconds_, error_;
};

/// Tooltip of the point under the cursor.
void drawPointTooltip(const TradeResult& result, const Chart& chart) {
    const ImVec2 cursor = ImGui::GetMousePos();
    const TradePoint* nearest = nullptr;
    float distance = scaled(8.0f);
    for (const TradePoint& p : result.points) {
        if (!Chart::isDrawn(p)) continue;
        const ImVec2 at = chart.position(p);
        const float away = std::hypot(at.x - cursor.x, at.y - cursor.y);
        if (away < distance) {
            distance = away;
            nearest = &p;
        }
    }
    if (nearest == nullptr)
        return tooltip(
            "Each mark is a combination of settings: left is faster, down is more accurate. Blue: Pareto "
            "front. Orange: presets. Ring: the current settings.");
    tooltip(fmt::format("{}\n{:.3g} s [{:.3g}, {:.3g}]\nRMSE {:.3g} [{:.3g}, {:.3g}]{}", nearest->name,
                        nearest->seconds.value, nearest->seconds.lower, nearest->seconds.upper,
                        nearest->error.value, nearest->error.lower, nearest->error.upper,
                        nearest->dominatedBy.empty() ? "" : "\ndominated by " + nearest->dominatedBy));
}

void drawChart(const TradeResult& result, std::optional<std::size_t> here) {
    const ImVec2 size(ImGui::GetContentRegionAvail().x, scaled(170.0f)), at = ImGui::GetCursorScreenPos();
    const Chart chart(result, at, size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ui::area("Chart", size);
    draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(20, 22, 26, 255));
    for (const TradePoint& p : result.points)
        if (Chart::isDrawn(p)) draw.AddCircleFilled(chart.position(p), scaled(2.0f), kOther);
    for (std::size_t i = 0; i < result.paretoFront.size(); ++i) {
        const ImVec2 to = chart.position(result.points[result.paretoFront[i]]);
        if (i > 0)
            draw.AddLine(chart.position(result.points[result.paretoFront[i - 1]]), to, kFront, scaled(1.5f));
        draw.AddCircleFilled(to, scaled(2.5f), kFront);
    }
    for (const TradePreset& d : result.presetPoints) {
        const ImVec2 to = chart.position(result.points[d.point]);
        draw.AddCircleFilled(to, scaled(4.0f), kPreset);
        const float rightmost = at.x + size.x - ImGui::CalcTextSize(d.preset.c_str()).x - scaled(2.0f);
        draw.AddText({std::min(to.x + scaled(6.0f), rightmost), to.y - scaled(17.0f)}, kPreset,
                     d.preset.c_str());
    }
    if (here) draw.AddCircle(chart.position(result.points[*here]), scaled(7.0f), kHere, 0, scaled(2.0f));
    const char* axes = "error up, seconds right";
    draw.AddText({at.x + scaled(4.0f), at.y + size.y - scaled(16.0f)}, IM_COL32(148, 156, 168, 255), axes);
    if (ImGui::IsItemHovered()) drawPointTooltip(result, chart);
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
        drawChart(*result, here);
        drawPosition(*result, here);
        dimText(fmt::format("{} x {} pixels, threads: {};\ntime differences below {:.0f} % are noise",
                            result->width, result->height, result->threads,
                            100.0 * result->smallestTimeDifference));
    }
    for (const std::string& remark : result->remarks) wrappedText(remark);
}

}  // namespace rayscope::viewer
