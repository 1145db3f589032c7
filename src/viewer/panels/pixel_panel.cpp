// The samples of a pixel: their positions, and the radiance of each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/overlay/overlay.h"
#include "viewer/panels/ray_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// With more samples than this, only the selected one is outlined.
constexpr std::size_t kMaxCircles = 256;

void drawDot(ImDrawList& draw, ImVec2 center, ImU32 color, bool chosen, bool amongMany) {
    const float radius = scaled(chosen ? 4.5f : 3.0f), half = scaled(1.0f);
    if (amongMany && !chosen)
        return draw.AddRectFilled({center.x - half, center.y - half}, {center.x + half, center.y + half},
                                  color);
    draw.AddCircleFilled(center, radius, color);
    draw.AddCircle(center, radius, chosen ? IM_COL32(255, 255, 255, 255) : IM_COL32(130, 134, 142, 255));
}

/// The pixel as a square with a dot per sample in its colour, over the strata of the jittered sampler.
void drawGrid(DebugRays& rays, const DebugRays::PixelRecording& recording, float side) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ui::area("Sample positions", {side, side});
    draw.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(20, 22, 26, 255));
    const int cells = static_cast<int>(std::floor(std::sqrt(static_cast<double>(recording.samples()))));
    for (int i = 0; i <= cells && cells <= 64; ++i) {
        const float offset = side * static_cast<float>(i) / static_cast<float>(cells);
        const ImU32 color = IM_COL32(70, 74, 82, 255);
        draw.AddLine({at.x + offset, at.y}, {at.x + offset, at.y + side}, color);
        draw.AddLine({at.x, at.y + offset}, {at.x + side, at.y + offset}, color);
    }
    int nearest = -1;
    float nearestDistance = scaled(6.0f);
    for (std::size_t i = 0; i < recording.pixel.positions.size(); ++i) {
        const glm::vec2 offset = glm::vec2(recording.pixel.positions[i]) * side;
        const ImVec2 center{at.x + offset.x, at.y + offset.y};
        const bool chosen = static_cast<int>(i) == recording.tree().name.index;
        drawDot(draw, center, toU32(displayColor(Rgb(recording.pixel.values[i]))), chosen,
                recording.pixel.positions.size() > kMaxCircles);
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const float distance = std::hypot(mouse.x - center.x, mouse.y - center.y);
        if (distance < nearestDistance) {
            nearestDistance = distance;
            nearest = static_cast<int>(i);
        }
    }
    if (!ImGui::IsItemHovered()) return;
    ImGui::SetTooltip("%s", nearest >= 0 ? fmt::format("sample {}", nearest).c_str()
                                         : "Positions of the samples in the pixel. Click one to select it.");
    if (nearest >= 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) rays.selectSample(nearest);
}

/// A bar per sample, outliers outlined in orange, and the running mean as a line. A click selects a sample.
void drawStrip(DebugRays& rays, const DebugRays::PixelRecording& recording, float width, float height) {
    const probe::SampleStatistics& s = recording.statistics;
    const auto count = static_cast<int>(s.luminance.size());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ui::area("Sample strip", {width, height});
    draw.AddRectFilled(at, {at.x + width, at.y + height}, IM_COL32(20, 22, 26, 255));
    double highest = 1e-12;
    for (const double x : s.luminance)
        if (std::isfinite(x)) highest = std::max(highest, x);
    const auto xOf = [&](double i) { return at.x + static_cast<float>(i / count) * width; };
    const auto yOf = [&](double value) {
        const double fraction = std::isfinite(value) ? std::clamp(value / highest, 0.0, 1.0) : 1.0;
        return at.y + height * static_cast<float>(1.0 - fraction);
    };
    // With more samples than pixels, each bar shows the brightest of its samples.
    const int stride = std::max(1, count / std::max(1, static_cast<int>(width)));
    for (int first = 0; first < count; first += stride) {
        int i = first;
        for (int other = first; other < std::min(count, first + stride); ++other)
            if (!(s.luminance[static_cast<std::size_t>(other)] <= s.luminance[static_cast<std::size_t>(i)]))
                i = other;
        const double value = s.luminance[static_cast<std::size_t>(i)];
        ImU32 color = toU32(displayColor(Rgb(recording.pixel.values[static_cast<std::size_t>(i)])));
        if (!std::isfinite(value)) color = IM_COL32(255, 0, 255, 255);
        draw.AddRectFilled({xOf(i), yOf(value)}, {std::max(xOf(i + 1) - 1.0f, xOf(i) + 1.0f), at.y + height},
                           color);
    }
    for (const std::size_t i : s.outliers)
        draw.AddRect({xOf(static_cast<double>(i)), yOf(s.luminance[i])},
                     {xOf(static_cast<double>(i) + 1.0), at.y + height}, IM_COL32(240, 165, 30, 255));
    for (int i = stride; i < count; i += stride)
        draw.AddLine({xOf(i - stride + 0.5), yOf(s.runningMean[static_cast<std::size_t>(i - stride)])},
                     {xOf(i + 0.5), yOf(s.runningMean[static_cast<std::size_t>(i)])},
                     IM_COL32(90, 180, 235, 255), scaled(1.5f));
    if (!ImGui::IsItemHovered() || count == 0) return;
    const int under =
        std::clamp(static_cast<int>((ImGui::GetIO().MousePos.x - at.x) / width * static_cast<float>(count)),
                   0, count - 1);
    ImGui::SetTooltip(
        "%s", fmt::format("sample {}: {:.5g}", under, s.luminance[static_cast<std::size_t>(under)]).c_str());
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) rays.selectSample(under);
}

}  // namespace

void drawPixelSamples(Workspace& workspace, const DebugRays::PixelRecording& recording) {
    const probe::SampleStatistics& s = recording.statistics;
    const float side = scaled(96.0f), gap = ImGui::GetStyle().ItemSpacing.x;
    drawGrid(workspace.rays, recording, side);
    ImGui::SameLine(0.0f, gap);
    ImGui::BeginGroup();
    drawStrip(workspace.rays, recording, ImGui::GetContentRegionAvail().x,
              side - 2.0f * ImGui::GetTextLineHeightWithSpacing());
    text(fmt::format("mean {:.4g} ± {:.2g}", s.mean, s.errorOfMean()));
    tooltip("Mean luminance of the samples and its standard error.");
    dimText(fmt::format("{} outliers of {}", s.outliers.size(), s.luminance.size()));
    ImGui::EndGroup();
}

void drawPins(Workspace& workspace) {
    DebugRays& rays = workspace.rays;
    if (rays.pins.empty()) return dimText("Press P to pin the recorded pixel.");
    if (!ImGui::BeginTable("pins", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* name : {"pixel", "mean", "std. error", "rays"}) ImGui::TableSetupColumn(name);
    ImGui::TableHeadersRow();
    std::size_t removed = rays.pins.size();
    for (std::size_t i = 0; i < rays.pins.size(); ++i) {
        const DebugRays::Pin& pin = rays.pins[i];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(i));
        if (ui::selectable(fmt::format("{}, {}", pin.pixel.x, pin.pixel.y).c_str(), false,
                           ImGuiSelectableFlags_SpanAllColumns))
            removed = i;
        ImGui::PopID();
        tooltip(pin.surface + "\nClick to remove.");
        for (const std::string& content : {fmt::format("{:.4g}", pin.mean), fmt::format("{:.2g}", pin.error),
                                           fmt::format("{:.1f}", pin.raysPerSample)}) {
            ImGui::TableNextColumn();
            text(content);
        }
    }
    ImGui::EndTable();
    if (removed < rays.pins.size()) rays.pins.erase(rays.pins.begin() + static_cast<std::ptrdiff_t>(removed));
}

}  // namespace rayscope::viewer
