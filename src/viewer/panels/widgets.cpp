#include "viewer/panels/widgets.h"

#include <fmt/format.h>

#include <algorithm>

#include "viewer/panels/theme.h"

namespace rayscope::viewer {

ImU32 toU32(const glm::vec4& color) {
    return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, color.a});
}

std::string vectorText(const glm::dvec3& v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); }

void text(std::string_view content) {
    constexpr std::size_t kMostShown = 4000;
    if (content.size() <= kMostShown) {
        ImGui::TextUnformatted(content.data(), content.data() + content.size());
    } else {
        std::size_t end = kMostShown;
        while (end > 0 && (static_cast<unsigned char>(content[end]) & 0xc0) == 0x80) --end;
        const std::string shown = std::string(content.substr(0, end)) + " ...";
        ImGui::TextUnformatted(shown.c_str());
    }
    ui::noteText(content);
}

void coloredText(const ImVec4& color, std::string_view content) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text(content);
    ImGui::PopStyleColor();
}

void dimText(std::string_view content) { coloredText(kDimText, content); }

void wrappedText(std::string_view content) {
    ImGui::PushTextWrapPos(0.0f);
    text(content);
    ImGui::PopTextWrapPos();
}

bool labelledRow(std::string_view label, bool emphasised, std::string_view help) {
    ui::noteRow(label);
    constexpr float kLabelFraction = 0.49f;
    const float start = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    if (emphasised)
        text(label);
    else
        coloredText({0.74f, 0.76f, 0.79f, 1.0f}, label);
    const bool reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (!help.empty()) tooltip(help);
    // A label that is longer than its part moves what follows.
    const float labelEnd = ImGui::GetItemRectSize().x + ImGui::GetStyle().ItemSpacing.x;
    const float part = std::max(kLabelFraction * width, labelEnd);
    ImGui::SameLine(start + part);
    ImGui::SetNextItemWidth(width - part);
    return reset;
}

void valueRow(std::string_view label, std::string_view content, std::string_view help) {
    const float labelEnd =
        ImGui::GetCursorPosX() + ImGui::CalcTextSize(label.data(), label.data() + label.size()).x;
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    labelledRow(label, false, help);
    const float width = ImGui::CalcTextSize(content.data(), content.data() + content.size()).x;
    const float leftmost = labelEnd + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(std::max(leftmost, std::min(ImGui::GetCursorPosX(), right - width)));
    fittedText(content);
}

void fittedText(std::string_view content) {
    const auto widthOf = [](std::string_view part) {
        return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
    };
    const float available = ImGui::GetContentRegionAvail().x;
    if (widthOf(content) <= available) return text(content);
    constexpr std::string_view kCut = "...";
    std::size_t fits = 0, beyond = std::min<std::size_t>(content.size(), 4000);
    while (fits + 1 < beyond) {
        const std::size_t middle = (fits + beyond) / 2;
        (widthOf(content.substr(0, middle)) + widthOf(kCut) <= available ? fits : beyond) = middle;
    }
    while (fits > 0 && (static_cast<unsigned char>(content[fits]) & 0xc0) == 0x80) --fits;
    const std::string shown = std::string(content.substr(0, fits)).append(kCut);
    ImGui::TextUnformatted(shown.c_str());
    ui::noteText(content);
    tooltip(content);
}

void tooltip(std::string_view content) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    showTooltip(content);
}

void showTooltip(std::string_view content) {
    // Inside BeginDisabled() everything is faded.
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28.0f);
    text(content);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

bool keyPressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

bool enterPressed() {
    return !ImGui::IsWindowAppearing() && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
           (keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_KeyPadEnter));
}

bool colorRow(const char* label, Rgb& color) {
    labelledRow(label);
    ImGui::PushID(label);
    const auto draw = [&] {
        return ImGui::ColorEdit3(
            "##color", &color.x,
            ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions);
    };
    const bool edited = ui::noted("##color", ui::finiteEdit({&color.x, 3}, draw));
    ImGui::PopID();
    return edited;
}

bool vectorRow(const char* label, glm::vec3& value, float speed) {
    labelledRow(label);
    ImGui::PushID(label);
    // Three numbers of four digits need the full width.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2.0f), ImGui::GetStyle().FramePadding.y});
    const auto draw = [&] { return ImGui::DragFloat3("##vector", &value.x, speed, 0.0f, 0.0f, "%.4g"); };
    const bool edited = ui::noted("##vector", ui::finiteEdit({&value.x, 3}, draw));
    ImGui::PopStyleVar();
    ImGui::PopID();
    return edited;
}

void pictureLabel(const char* content, ImVec2 position, bool leftOf) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const ImVec2 extent = ImGui::CalcTextSize(content);
    const float pad = scaled(5.0f), left = leftOf ? position.x - extent.x - 2.0f * pad : position.x;
    draw.AddRectFilled({left, position.y}, {left + extent.x + 2.0f * pad, position.y + extent.y + pad},
                       IM_COL32(15, 17, 20, 200), scaled(3.0f));
    draw.AddText({left + pad, position.y + 0.5f * pad}, IM_COL32(235, 237, 240, 255), content);
}

bool stoppableProgress(double fraction) {
    ImGui::ProgressBar(static_cast<float>(fraction), {-1.0f, 0.0f});
    return ui::button("Stop and keep the results so far", {-1.0f, 0.0f});
}

bool toggleButton(const char* label, bool chosen, float width) {
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    const bool pressed = ui::button(label, {width, 0.0f});
    if (chosen) ImGui::PopStyleColor();
    return pressed;
}

}  // namespace rayscope::viewer
