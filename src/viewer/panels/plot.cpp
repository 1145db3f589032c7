#include "viewer/panels/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr ImU32 kGround = IM_COL32(20, 22, 26, 255), kGridLine = IM_COL32(255, 255, 255, 26);

std::string tickText(double value) { return fmt::format("{:.4g}", value); }

double partOf(const PlotAxis& axis, double value) {
    const auto mapped = [&](double v) { return axis.logarithmic ? std::log(v) : v; };
    const double span = mapped(axis.high) - mapped(axis.low);
    return span > 0.0 ? (mapped(value) - mapped(axis.low)) / span : 0.5;
}

double valueAt(const PlotAxis& axis, double part) {
    if (!axis.logarithmic) return axis.low + part * (axis.high - axis.low);
    return axis.low * std::pow(axis.high / axis.low, part);
}

std::vector<double> multiples(const PlotAxis& axis, double step) {
    const double slack = 1e-9 * (axis.high - axis.low);
    std::vector<double> ticks;
    // Adding 0 makes -0 positive.
    for (double i = std::ceil((axis.low - slack) / step); i * step <= axis.high + slack; i += 1.0)
        ticks.push_back(i * step + 0.0);
    return ticks;
}

std::vector<double> linearTicks(const PlotAxis& axis, int most) {
    const double span = axis.high - axis.low;
    if (!(span > 0.0) || !std::isfinite(span)) return {axis.low};
    const double power = std::pow(10.0, std::floor(std::log10(span / most)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        const std::vector<double> ticks = multiples(axis, factor * power);
        if (ticks.size() <= static_cast<std::size_t>(most)) return ticks;
    }
    return {axis.low};
}

/// Powers of ten, or of them also 2 and 5 times the powers if there are few.
std::vector<double> logarithmicTicks(const PlotAxis& axis, int most) {
    std::vector<double> ticks, powers;
    for (double power = std::pow(10.0, std::floor(std::log10(axis.low))); power <= axis.high; power *= 10.0) {
        for (const double factor : {1.0, 2.0, 5.0})
            if (factor * power >= axis.low && factor * power <= axis.high) ticks.push_back(factor * power);
        if (power >= axis.low) powers.push_back(power);
    }
    if (static_cast<int>(ticks.size()) <= most && ticks.size() >= 2) return ticks;
    if (powers.size() < 2) return linearTicks(axis, most);
    const std::size_t stride =
        (powers.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
    std::vector<double> some;
    for (std::size_t i = 0; i < powers.size(); i += stride) some.push_back(powers[i]);
    return some;
}

}  // namespace

std::vector<double> plotTicks(const PlotAxis& axis, int most) {
    return axis.logarithmic ? logarithmicTicks(axis, most) : linearTicks(axis, most);
}

Plot::Plot(const char* label, float height, const PlotAxis& x, const PlotAxis& y) : x_(x), y_(y) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetFontSize(), gap = scaled(4.0f);
    float left = 0.0f;
    for (const double tick : plotTicks(y_, 4))
        left = std::max(left, ImGui::CalcTextSize(tickText(tick).c_str()).x + 2.0f * gap);
    lower_ = {start.x + left, start.y + line + gap};
    size_ = {std::max(width - left - gap, scaled(40.0f)),
             std::max(height - 3.0f * (line + gap), scaled(20.0f))};
    ImGui::SetCursorScreenPos(lower_);
    ui::area(label, size_);
    hovered_ = ImGui::IsItemHovered();
    clicked_ = hovered_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    ImGui::GetWindowDrawList()->AddRectFilled(lower_, {lower_.x + size_.x, lower_.y + size_.y}, kGround);
    drawAxes(line);
    // Titles are texts, so that they can be read by tests and cut by the panel.
    ImGui::SetCursorScreenPos(start);
    dimText(y_.title);
    ImGui::SetCursorScreenPos({std::max(lower_.x, start.x + width - ImGui::CalcTextSize(x_.title).x),
                               lower_.y + size_.y + line + gap});
    dimText(x_.title);
    ImGui::SetCursorScreenPos({start.x, start.y + height});
}

void Plot::drawAxes(float line) const {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::ColorConvertFloat4ToU32(kDimText);
    const float gap = scaled(4.0f), right = lower_.x + size_.x, bottom = lower_.y + size_.y;
    for (const double tick : plotTicks(y_, 4)) {
        const float y = position(x_.low, tick).y;
        const std::string number = tickText(tick);
        draw.AddLine({lower_.x, y}, {right, y}, kGridLine);
        draw.AddText({lower_.x - gap - ImGui::CalcTextSize(number.c_str()).x, y - 0.5f * line}, color,
                     number.c_str());
    }
    float free = lower_.x - scaled(40.0f);
    for (const double tick : plotTicks(x_, 6)) {
        const float x = position(tick, y_.low).x;
        const std::string number = tickText(tick);
        const float half = 0.5f * ImGui::CalcTextSize(number.c_str()).x;
        draw.AddLine({x, lower_.y}, {x, bottom}, kGridLine);
        const float start = std::min(x - half, right - 2.0f * half);
        if (start < free) continue;
        draw.AddText({start, bottom + 0.5f * gap}, color, number.c_str());
        free = start + 2.0f * half + gap;
    }
}

ImVec2 Plot::position(double x, double y) const {
    return {lower_.x + size_.x * static_cast<float>(partOf(x_, x)),
            lower_.y + size_.y * static_cast<float>(1.0 - partOf(y_, y))};
}

double Plot::xAtCursor() const {
    const float part = (ImGui::GetIO().MousePos.x - lower_.x) / size_.x;
    return valueAt(x_, std::clamp(static_cast<double>(part), 0.0, 1.0));
}

}  // namespace rayscope::viewer
