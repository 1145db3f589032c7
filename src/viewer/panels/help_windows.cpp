#include <fmt/format.h>

#include <cstring>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kGestures[][2] = {
    {"drag", "Orbit the camera around the point it looks at; in fly mode look around."},
    {"right drag, middle drag", "Pan the camera."},
    {"wheel", "Zoom toward or away from the cursor; in fly mode change the speed."},
    {"right button + W A S D Q E", "Fly while the button is held."},
    {"click on a light",
     "Select it; its arrows move it along the axes, the square in the plane of the screen."},
    {"Ctrl+click", "Record the rays of the pixel, like R."},
    {"drop a file", "Open a scene or a mesh."},
    {"Ctrl+click on a slider", "Type a number."},
    {"double-click on a label", "Reset the setting."},
};

void row(std::string_view left, std::string_view right) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    coloredText({0.62f, 0.78f, 0.98f, 1.0f}, left);
    ImGui::TableNextColumn();
    wrappedText(right);
}

bool beginKeyTable(const char* name) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit)) return false;
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, scaled(200.0f));
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

}  // namespace

void drawKeysWindow(Workspace& workspace) {
    if (!workspace.view.showKeys) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.37f, display.y * 0.5f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(scaled(640.0f), display.x * 0.9f), std::min(scaled(620.0f), display.y * 0.88f)},
        ImGuiCond_Appearing);
    if (ImGui::Begin("Keys and gestures", &workspace.view.showKeys,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNavInputs)) {
        const ui::Scope scope("Keys and gestures");
        const char* menu = "";
        bool inTable = false;
        for (const CommandInfo& info : commandTable()) {
            if (std::strcmp(menu, info.menu) != 0) {
                if (inTable) ImGui::EndTable();
                menu = info.menu;
                dimText(menu);
                inTable = beginKeyTable(menu);
            }
            if (inTable) row(shortcutText(info), info.help);
        }
        if (inTable) ImGui::EndTable();
        dimText("Mouse");
        if (beginKeyTable("mouse")) {
            for (const auto& [gesture, meaning] : kGestures) row(gesture, meaning);
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

void drawStatisticsWindow(Workspace& workspace) {
    if (!workspace.view.showStatistics) return;
    ImGui::SetNextWindowPos({scaled(12.0f), scaled(34.0f)}, ImGuiCond_Appearing);
    if (ImGui::Begin(
            "Statistics", &workspace.view.showStatistics,
            ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNavInputs)) {
        const ui::Scope scope("Statistics");
        const FrameTimes& times = workspace.frameTimes;
        const double median = times.quantile(0.5);
        text(fmt::format("last {} frames: median {:.1f} ms ({:.0f}/s), 95th percentile {:.1f} ms",
                         times.count(), median * 1e3, median > 0.0 ? 1.0 / median : 0.0,
                         times.quantile(0.95) * 1e3));
        ImGui::PlotLines("##times", times.latest().data(), static_cast<int>(times.latest().size()), 0,
                         nullptr, 0.0f, 0.1f, {scaled(380.0f), scaled(60.0f)});
        const RenderStatus& status = workspace.render.status();
        text(fmt::format("tracing threads: {}", workspace.render.threads()));
        text(fmt::format("rays: {} ({:.2f} Mray/s)", status.rays, workspace.render.raysPerSecond() * 1e-6));
        text(fmt::format("scene preparation: {:.3f} s", status.compileSeconds));
        text(fmt::format("BVH build: {:.3f} s", status.buildSeconds));
        if (status.sahCostGrowth != 1.0)
            text(fmt::format("SAH cost after refit: {:.3f}x", status.sahCostGrowth));
        if (ui::button("Reset")) workspace.frameTimes.clear();
    }
    ImGui::End();
}

void drawErrorDialog(Workspace& workspace) {
    constexpr const char* kTitle = "Error";
    if (!workspace.errorMessage.empty() && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.4f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(scaled(560.0f), display.x * 0.9f), 0.0f});
    if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoResize)) return;
    const ui::Scope scope(kTitle);
    wrappedText(workspace.errorMessage);
    ImGui::Spacing();
    if (ui::button("Close", {scaled(90.0f), 0.0f}) || enterPressed() || workspace.closeDialogs) {
        workspace.errorMessage.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace rayscope::viewer
