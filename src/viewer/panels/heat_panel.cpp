#include <fmt/format.h>

#include <algorithm>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawChoices(HeatMap& heat) {
    labelledRow("Quantity", false, infoOf(heat.aov).help);
    const auto drawQuantities = [&] {
        for (const AovInfo& info : aovTable()) {
            if (info.isColor) continue;
            if (ui::selectable(std::string(info.name).c_str(), info.aov == heat.aov)) {
                heat.aov = info.aov;
                heat.fitRange = true;
            }
            tooltip(info.help);
        }
    };
    ui::combo("##aov", std::string(infoOf(heat.aov).name).c_str(), drawQuantities,
              ImGuiComboFlags_HeightLarge);
    labelledRow("Colour map", false, "All are uniform in lightness and safe for colour-blind readers.");
    ui::combo("##map", kColorMapNames[static_cast<int>(heat.map)].data(), [&] {
        for (int i = 0; i < 3; ++i)
            if (ui::selectable(kColorMapNames[i].data(), static_cast<int>(heat.map) == i)) {
                heat.map = static_cast<ColorMap>(i);
                heat.recolor();
            }
    });
    labelledRow("Samples", false, "Samples per pixel that are counted.");
    ui::sliderInt("##samples", &heat.samples, 1, 64, "%d",
                  ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

/// The histogram of the values in the colours of the map; the ends of the range can be dragged.
void drawHistogram(HeatMap& heat) {
    const HeatStatistics& s = heat.statistics();
    const float width = ImGui::GetContentRegionAvail().x, height = scaled(80.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ui::area("Histogram", {width, height});
    draw.AddRectFilled(at, {at.x + width, at.y + height}, IM_COL32(20, 22, 26, 255));
    const std::size_t most = std::max<std::size_t>(1, *std::max_element(s.counts.begin(), s.counts.end()));
    const auto bars = static_cast<float>(s.counts.size());
    for (std::size_t i = 0; i < s.counts.size(); ++i) {
        const double value = s.lowest + (s.highest - s.lowest) * (static_cast<double>(i) + 0.5) /
                                            static_cast<double>(s.counts.size());
        const double range = static_cast<double>(heat.to) - static_cast<double>(heat.from);
        const double fraction = range > 0.0 ? (value - static_cast<double>(heat.from)) / range : 0.0;
        const ImU32 color = toU32(toDisplay(mapColor(heat.map, fraction)));
        // The square root keeps rare values visible beside common ones.
        const float filled = std::sqrt(static_cast<float>(s.counts[i]) / static_cast<float>(most));
        const float x = at.x + width * static_cast<float>(i) / bars;
        draw.AddRectFilled({x, at.y + height * (1.0f - filled)}, {x + width / bars, at.y + height}, color);
    }
    if (ImGui::IsItemActive() && s.highest > s.lowest) {
        const float fraction = std::clamp((ImGui::GetIO().MousePos.x - at.x) / width, 0.0f, 1.0f);
        const auto value =
            static_cast<float>(s.lowest + (s.highest - s.lowest) * static_cast<double>(fraction));
        // The nearer end follows the cursor.
        (std::abs(value - heat.from) < std::abs(value - heat.to) ? heat.from : heat.to) = value;
        heat.fitRange = false;
        heat.recolor();
    }
    for (const float end : {heat.from, heat.to}) {
        if (!(s.highest > s.lowest)) break;
        const double fraction = (static_cast<double>(end) - s.lowest) / (s.highest - s.lowest);
        const float x = at.x + width * static_cast<float>(std::clamp(fraction, 0.0, 1.0));
        draw.AddLine({x, at.y}, {x, at.y + height}, IM_COL32(255, 255, 255, 220), scaled(1.5f));
    }
    tooltip("Number of pixels by value. Drag the ends of the colour range.");
    dimText(fmt::format("{:.4g} to {:.4g}, mean {:.4g}", s.lowest, s.highest, s.mean));
}

void drawRange(HeatMap& heat) {
    labelledRow("Range");
    float ends[] = {heat.from, heat.to};
    const float speed = std::max(1e-6f, 0.005f * std::abs(heat.to - heat.from));
    const auto draw = [&] { return ImGui::DragFloat2("##range", ends, speed, 0.0f, 0.0f, "%.4g"); };
    if (ui::noted("##range", ui::finiteEdit(ends, draw))) {
        heat.from = ends[0];
        heat.to = ends[1];
        heat.fitRange = false;
        heat.recolor();
    }
    if (ui::button("Fit range to values", {-1.0f, 0.0f})) {
        heat.fitRange = true;
        heat.from = static_cast<float>(std::min(heat.statistics().lowest, 0.0));
        heat.to = static_cast<float>(heat.statistics().upperPercentile);
        heat.recolor();
    }
    tooltip("From zero, or the lowest value if it is negative, to the 99th percentile.");
}

}  // namespace

void drawHeatPanel(Workspace& workspace) {
    HeatMap& heat = workspace.heat;
    if (ui::checkbox("Show heat map (M)", &heat.shown) && heat.shown) workspace.view.traced = true;
    drawChoices(heat);
    if (heat.busy()) dimText("computing ...");
    if (heat.values() == nullptr) return;
    drawHistogram(heat);
    drawRange(heat);
    if (!workspace.cursor || !heat.shown) return;
    const glm::ivec2 pixel = workspace.cursor->pixel;
    const RgbImage& values = *heat.values();
    if (pixel.x >= values.width || pixel.y >= values.height) return;
    text(fmt::format("pixel {}, {}: {:.6g}", pixel.x, pixel.y, values.at(pixel.x, pixel.y).x));
}

}  // namespace rayscope::viewer
