// The preset slider and the stop criteria.
#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// The index of the preset that the settings equal; -1 if none.
int presetIndex(const Settings& settings, bool blurred) {
    const std::vector<Preset>& all = presets();
    for (std::size_t i = 0; i < all.size(); ++i) {
        Settings applied = settings;
        applyPreset(applied, all[i], blurred);
        if (applied == settings) return static_cast<int>(i);
    }
    return -1;
}

void drawPresetSlider(Settings& settings, bool blurred) {
    const std::vector<Preset>& all = presets();
    int position = presetIndex(settings, blurred);
    const std::string name(position < 0 ? "custom" : all[static_cast<std::size_t>(position)].name);
    labelledRow("Preset", position >= 0,
                "From fast to accurate: preview, balanced, final or reference, like --preset. Changes only "
                "settings that trade speed for accuracy, not the content of the scene.");
    if (ui::sliderInt("##preset", &position, 0, static_cast<int>(all.size()) - 1, name.c_str(), kClamp))
        applyPreset(settings, all[static_cast<std::size_t>(position)], blurred);
    if (position >= 0) tooltip(all[static_cast<std::size_t>(position)].meaning);
}

void drawTarget(StopCriteria& stopCriteria) {
    labelledRow("Error target", stopCriteria.byError,
                "Traces until the RMSE of the picture is below this value at the confidence level below, "
                "regardless of the samples per pixel. Not available with the jittered sampler.");
    ui::checkbox("##byError", &stopCriteria.byError);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ui::sliderFloat("##error", &stopCriteria.error, 1e-4f, 0.1f, "%.4f",
                    kClamp | ImGuiSliderFlags_Logarithmic);
    if (stopCriteria.byError) {
        labelledRow("Confidence level", false, "Probability that the error is below the target.");
        float percent = 100.0f * stopCriteria.confidence;
        if (ui::sliderFloat("##confidence", &percent, 50.0f, 99.9f, "%.1f %%", kClamp))
            stopCriteria.confidence = percent / 100.0f;
    }
    labelledRow("Time limit", stopCriteria.byTime, "Stops tracing after this time.");
    ui::checkbox("##byTime", &stopCriteria.byTime);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    ui::sliderFloat("##seconds", &stopCriteria.seconds, 1.0f, 3600.0f, "%.0f s",
                    kClamp | ImGuiSliderFlags_Logarithmic);
}

}  // namespace

void drawQualityPanel(Workspace& workspace) {
    drawPresetSlider(workspace.edit.settings, blursPixels(workspace.needs(), workspace.edit.camera));
    drawTarget(workspace.stopCriteria);
    const std::optional<ErrorForecast> forecast = workspace.render.forecast();
    labelledRow("Current error", false,
                "Estimated RMSE of the picture, and its upper bound at the confidence level in parentheses. "
                "With the Sobol sampler the estimate is conservative.");
    if (!workspace.view.traced || !forecast)
        dimText("unknown");
    else
        text(fmt::format("{:.2g} (< {:.2g})", forecast->estimate.error, forecast->estimate.upper));
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
