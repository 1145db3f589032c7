// A control for each row of the settings table.
#include <fmt/format.h>

#include <algorithm>

#include "settings/table.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// Wider ranges of integers have logarithmic sliders.
constexpr int kWidestLinear = 120;

void drawControl(const settings::Toggle& row, Settings& settings) {
    ui::checkbox("##value", &(settings.*row.member));
}

void drawControl(const settings::Range<int>& row, Settings& settings) {
    int& value = settings.*row.member;
    const bool logarithmic = row.logarithmic || row.highest - row.lowest > kWidestLinear;
    ui::sliderInt("##value", &value, row.lowest, row.highest, "%d",
                  kClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
}

/// A slider for ranges of a few powers of ten, else a drag field with a speed proportional to the value.
void drawControl(const settings::Range<float>& row, Settings& settings) {
    constexpr float kWidestSlider = 1e4f;
    float& value = settings.*row.member;
    const bool logarithmic = row.logarithmic || row.lowest == 0.0f;
    if (row.highest - row.lowest <= kWidestSlider)
        ui::sliderFloat("##value", &value, row.lowest, row.highest, "%.3g",
                        kClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
    else
        ui::dragFloat("##value", &value, std::max(0.005f, 0.01f * std::abs(value)), row.lowest, row.highest,
                      "%.4g", kClamp);
}

template <class E, std::size_t N>
void drawControl(const settings::Choice<E, N>& row, Settings& settings) {
    const auto current = static_cast<std::size_t>(settings.*row.member);
    const std::string shown(row.names[current]);
    ui::combo("##value", shown.c_str(), [&] {
        for (std::size_t i = 0; i < N; ++i)
            if (ui::selectable(std::string(row.names[i]).c_str(), i == current))
                settings.*row.member = static_cast<E>(i);
    });
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
std::string helpOf(const Row& row, const Settings& settings, std::string_view inactiveReason) {
    std::string help =
        fmt::format("{}\n\n--set {}={}\n{}{}{}, default {}\nDouble-click the label or right-click to reset.",
                    row.text.help, row.text.key, textOf(settings, row.text.key), rangeText(row),
                    row.text.unit.empty() ? "" : " ", row.text.unit, textOf(Settings{}, row.text.key));
    if (!inactiveReason.empty()) help = fmt::format("Inactive: {}.\n\n{}", inactiveReason, help);
    return help;
}

template <class Row>
void drawRow(const Row& row, Settings& settings, const SceneRequirements& needs) {
    const Settings defaults;
    const bool edited = settings.*row.member != defaults.*row.member;
    // Missing scene content takes precedence: no other setting could change it.
    std::string_view reason = inactiveReason(needs, row.text.key);
    if (reason.empty()) reason = row.inactive(settings);
    const std::string id(row.text.key);
    ImGui::PushID(id.c_str());
    ImGui::BeginDisabled(!reason.empty());
    const std::string help = helpOf(row, settings, reason);
    bool reset = labelledRow(row.text.label, edited, help);
    drawControl(row, settings);
    tooltip(help);
    ImGui::EndDisabled();
    if (ImGui::BeginPopupContextItem("reset")) {
        if (ui::menuItem(fmt::format("Reset to {}", textOf(defaults, row.text.key)).c_str(), nullptr, false,
                         edited))
            reset = true;
        ui::closeOnEscape();
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
    if (ui::section("Quality")) drawQualityPanel(workspace);
    if (ui::section("Quality-speed study", 0)) drawTradePanel(workspace);
    static const std::vector<std::string_view> groups = groupsOfTable();
    for (const std::string_view group : groups) {
        const ImGuiTreeNodeFlags open = group == "Acceleration" ? 0 : ImGuiTreeNodeFlags_DefaultOpen;
        if (!ui::section(std::string(group).c_str(), open)) continue;
        settings::forEachSetting([&](const auto& row) {
            if (row.text.group != group) return;
            drawRow(row, workspace.edit.settings, workspace.needs());
            if (row.text.key == "depth_of_field") drawLensRows(workspace);
        });
        ImGui::Spacing();
    }
    if (ui::button("Reset all settings", {-1.0f, 0.0f})) workspace.edit.settings = Settings{};
    tooltip("Reset every setting to its default; can be undone.");
}

}  // namespace rayscope::viewer
