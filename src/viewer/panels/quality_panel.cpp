// The dial from fast to accurate, and when a picture is good enough.
#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;

/// The position of the dial that the settings are at; -1 between positions.
int presetIndex(const Settings& settings, bool blurred) {
    const std::vector<Preset>& all = presets();
    for (std::size_t i = 0; i < all.size(); ++i) {
        Settings turned = settings;
        applyPreset(turned, all[i], blurred);
        if (turned == settings) return static_cast<int>(i);
    }
    return -1;
}

void drawPresetSlider(Settings& settings, bool blurred) {
    const std::vector<Preset>& all = presets();
    int position = presetIndex(settings, blurred);
    const std::string name(position < 0 ? "own settings" : all[static_cast<std::size_t>(position)].name);
    labelledRow("Fast ... accurate", position >= 0,
                "Sets what trades speed for accuracy: preview, balanced, final or reference, as --preset "
                "does. What the scene shows stays as it is.");
    if (ImGui::SliderInt("##dial", &position, 0, static_cast<int>(all.size()) - 1, name.c_str(), kClamp))
        applyPreset(settings, all[static_cast<std::size_t>(position)], blurred);
    if (position >= 0) tooltip(all[static_cast<std::size_t>(position)].meaning);
}

void drawTarget(StopCriteria& stopCriteria) {
    labelledRow("Until the error is", stopCriteria.byError,
                "Goes on until the root mean squared error of the picture is below this with the confidence "
                "below, whatever the number of samples is set to. Not with the jittered sampler.");
    ImGui::Checkbox("##byError", &stopCriteria.byError);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderFloat("##error", &stopCriteria.error, 1e-4f, 0.1f, "%.4f",
                       kClamp | ImGuiSliderFlags_Logarithmic);
    if (stopCriteria.byError) {
        labelledRow("Sure to", false, "The confidence with which the error lies below the target.");
        float percent = 100.0f * stopCriteria.confidence;
        if (ImGui::SliderFloat("##confidence", &percent, 50.0f, 99.9f, "%.1f %%", kClamp))
            stopCriteria.confidence = percent / 100.0f;
    }
    labelledRow("Time limit", stopCriteria.byTime, "Stops tracing after so many seconds.");
    ImGui::Checkbox("##byTime", &stopCriteria.byTime);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::SliderFloat("##seconds", &stopCriteria.seconds, 1.0f, 3600.0f, "%.0f s",
                       kClamp | ImGuiSliderFlags_Logarithmic);
}

}  // namespace

void drawQualityPanel(Workspace& workspace) {
    drawPresetSlider(workspace.edit.settings, blursPixels(workspace.needs(), workspace.edit.camera));
    drawTarget(workspace.stopCriteria);
    const std::optional<ErrorForecast> forecast = workspace.render.forecast();
    labelledRow("Error now", false,
                "Of the picture as it is, from how much it still changes: the root mean squared error, and "
                "what it lies below with the confidence in brackets. With Sobol points it is rather less.");
    if (!workspace.view.traced || !forecast)
        dimText("not known yet");
    else
        text(fmt::format("{:.2g} (< {:.2g})", forecast->estimate.error, forecast->estimate.upper));
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
