// Every row of the settings table as a control.
#include <fmt/format.h>

#include <algorithm>

#include "settings/table.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawControl(const settings::Toggle& row, Settings& settings) {
    ImGui::Checkbox("##value", &(settings.*row.member));
}

/// A slider where its whole range fits, else a field to drag whose speed goes with its value.
void drawControl(const settings::Range<int>& row, Settings& settings) {
    int& value = settings.*row.member;
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (row.logarithmic)
        ImGui::SliderInt("##value", &value, row.lowest, row.highest, "%d",
                         flags | ImGuiSliderFlags_Logarithmic);
    else
        ImGui::SliderInt("##value", &value, row.lowest, row.highest, "%d", flags);
}

void drawControl(const settings::Range<float>& row, Settings& settings) {
    constexpr float kWidestSlider = 120.0f;
    float& value = settings.*row.member;
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (row.highest - row.lowest <= kWidestSlider)
        ImGui::SliderFloat(
            "##value", &value, row.lowest, row.highest, "%.3g",
            flags | (row.logarithmic || row.lowest == 0.0f ? ImGuiSliderFlags_Logarithmic : 0));
    else
        ImGui::DragFloat("##value", &value, std::max(0.005f, 0.01f * std::abs(value)), row.lowest,
                         row.highest, "%.4g", flags);
}

template <class E, std::size_t N>
void drawControl(const settings::Choice<E, N>& row, Settings& settings) {
    const auto current = static_cast<std::size_t>(settings.*row.member);
    const std::string shown(row.names[current]);
    if (!ImGui::BeginCombo("##value", shown.c_str())) return;
    for (std::size_t i = 0; i < N; ++i)
        if (ImGui::Selectable(std::string(row.names[i]).c_str(), i == current))
            settings.*row.member = static_cast<E>(i);
    ImGui::EndCombo();
}

std::string rangeText(const settings::Toggle&) { return "on or off"; }
template <class T>
std::string rangeText(const settings::Range<T>& row) {
    return fmt::format("{} to {}", row.lowest, row.highest);
}
template <class E, std::size_t N>
std::string rangeText(const settings::Choice<E, N>& row) {
    return fmt::format("{}", fmt::join(row.names, ", "));
}

template <class Row>
std::string explain(const Row& row, std::string_view idleReason) {
    const Settings defaults;
    std::string words =
        fmt::format("{}\n\n--set {}={}\n{}{}{}\nDouble-click the name or right-click to reset.",
                    row.text.help, row.text.key, textOf(defaults, row.text.key), rangeText(row),
                    row.text.unit.empty() ? "" : " ", row.text.unit);
    if (!idleReason.empty()) words = fmt::format("Without effect: {}.\n\n{}", idleReason, words);
    return words;
}

template <class Row>
void drawRow(const Row& row, Settings& settings, const SceneRequirements& needs) {
    const Settings defaults;
    const bool edited = settings.*row.member != defaults.*row.member;
    // What the scene does not contain comes first: no other setting could change that.
    std::string_view idleReason = inactiveReason(needs, row.text.key);
    if (idleReason.empty()) idleReason = row.inactive(settings);
    const std::string id(row.text.key);
    ImGui::PushID(id.c_str());
    ImGui::BeginDisabled(!idleReason.empty());
    const std::string help = explain(row, idleReason);
    bool reset = labelledRow(row.text.label, edited, help);
    drawControl(row, settings);
    tooltip(help);
    ImGui::EndDisabled();
    if (ImGui::BeginPopupContextItem("reset")) {
        if (ImGui::MenuItem(fmt::format("Reset to {}", textOf(defaults, row.text.key)).c_str(), nullptr,
                            false, edited))
            reset = true;
        ImGui::EndPopup();
    }
    if (reset) settings.*row.member = defaults.*row.member;
    ImGui::PopID();
}

std::vector<std::string_view> groupsOfTable() {
    std::vector<std::string_view> groups;
    settings::forEachSetting([&](const auto& row) {
        if (std::find(groups.begin(), groups.end(), row.text.group) == groups.end())
            groups.push_back(row.text.group);
    });
    return groups;
}

}  // namespace

void drawSettingsPanel(Workspace& workspace) {
    if (ImGui::CollapsingHeader("Speed and accuracy", ImGuiTreeNodeFlags_DefaultOpen))
        drawQualityPanel(workspace);
    if (ImGui::CollapsingHeader("Measured on this scene")) drawTradePanel(workspace);
    static const std::vector<std::string_view> groups = groupsOfTable();
    for (const std::string_view group : groups) {
        const ImGuiTreeNodeFlags open = group == "Acceleration" ? 0 : ImGuiTreeNodeFlags_DefaultOpen;
        if (!ImGui::CollapsingHeader(std::string(group).c_str(), open)) continue;
        settings::forEachSetting([&](const auto& row) {
            if (row.text.group == group) drawRow(row, workspace.edit.settings, workspace.needs());
        });
        ImGui::Spacing();
    }
    if (ImGui::Button("Reset all settings", {-1.0f, 0.0f})) workspace.edit.settings = Settings{};
    tooltip("Every setting back to its default; undo takes it back.");
}

}  // namespace rayscope::viewer
