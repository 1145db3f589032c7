#include <fmt/format.h>

#include <algorithm>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

void drawLoadingWindow(Workspace& workspace) {
    // Short loads end before anybody could read it.
    constexpr double kQuietSeconds = 0.3;
    constexpr const char* kTitle = "Loading";
    const SceneLoader& loader = workspace.loader;
    if (!loader.loading() || loader.seconds() < kQuietSeconds) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.4f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(scaled(460.0f), display.x * 0.9f), 0.0f});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                                        ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin(kTitle, nullptr, kFlags)) {
        const ui::Scope scope(kTitle);
        const SceneLoader::Step step = loader.step();
        wrappedText(loader.path());
        text(step.name.empty() ? "starting" : step.name);
        ImGui::ProgressBar(static_cast<float>(step.fraction), {-1.0f, 0.0f},
                           fmt::format("{:.0f} %", 100.0 * step.fraction).c_str());
        ImGui::Spacing();
        if (ui::button("Cancel", {scaled(110.0f), 0.0f})) workspace.cancelLoading();
        ImGui::SameLine();
        dimText(fmt::format("{:.0f} s", loader.seconds()));
    }
    ImGui::End();
}

}  // namespace rayscope::viewer
