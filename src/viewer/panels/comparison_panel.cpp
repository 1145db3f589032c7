// A picture that was kept beside the current one.
#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawModes(Comparison::View& view) {
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    const auto button = [&](const char* label, CompareMode mode, const char* help) {
        if (toggleButton(label, view.mode == mode, third)) view.mode = mode;
        tooltip(help);
    };
    button("Wipe", CompareMode::Wipe, "A on the left of a line that can be dragged, B on its right.");
    ImGui::SameLine();
    button("Flip", CompareMode::Flip, "One of the two; X changes to the other.");
    ImGui::SameLine();
    button("Difference", CompareMode::Difference, "What they differ by in each channel, brightened.");
    if (view.mode == CompareMode::Wipe) {
        labelledRow("Divider", false, "Or drag the line in the picture.");
        ImGui::SliderFloat("##divider", &view.divider, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    } else if (view.mode == CompareMode::Flip) {
        labelledRow("Shown (X)");
        const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
        if (toggleButton("A", view.flipped, half)) view.flipped = true;
        ImGui::SameLine();
        if (toggleButton("B", !view.flipped, half)) view.flipped = false;
    } else {
        labelledRow("Times", false, "What differences are multiplied with.");
        ImGui::SliderFloat("##brightness", &view.brightness, 0.1f, 1000.0f, "%.3g",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    }
}

void drawMetrics(const Comparison& comparison) {
    const ErrorMeasures* metrics = comparison.metrics();
    if (metrics == nullptr)
        return dimText(comparison.busy() ? "measuring ..." : "pictures of different sizes: no figures");
    valueRow("RMSE", fmt::format("{:.6g}", metrics->rmse), "Root of the mean squared difference, linear.");
    valueRow("Largest",
             fmt::format("{:.4g} at {}, {}", metrics->maximum, metrics->maximumX, metrics->maximumY),
             "Largest difference of a channel, linear.");
    valueRow("SSIM", fmt::format("{:.6f}", metrics->ssim),
             "Structural similarity of the luminance on a display; 1 for equal pictures.");
    valueRow("FLIP", fmt::format("{:.6f}", metrics->flip),
             "Mean difference that a person would see on a display; 0 for equal pictures.");
    if (comparison.metricsAreFinal())
        dimText("of the complete picture B against A");
    else
        dimText(comparison.busy() ? "so far; measuring ..." : "so far; B is not complete yet");
}

void drawSettingsOf(Workspace& workspace, const Comparison::Kept& a) {
    dimText(fmt::format("A: {} samples per pixel, {} x {}", a.samples, a.image.width, a.image.height));
    const std::vector<std::string> differences = differencesOf(a.state, workspace.edit);
    if (differences.empty()) dimText("B has the settings of A: change some.");
    for (const std::string& difference : differences) text(difference);
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ImGui::Button("Back to A's settings", {half, 0.0f})) workspace.edit.settings = a.state.settings;
    tooltip("B gets the settings of A; undo takes it back.");
    ImGui::SameLine();
    if (ImGui::Button("Forget A", {half, 0.0f})) workspace.comparison.discard();
}

}  // namespace

void drawComparisonPanel(Workspace& workspace) {
    Comparison& comparison = workspace.comparison;
    if (ImGui::Button("Keep the traced picture as A (K)", {-1.0f, 0.0f}))
        workspace.commands.push_back(Command::KeepPicture);
    tooltip(
        "With the settings it has. Then change settings: the new picture, B, has the same random numbers.");
    if (comparison.a() == nullptr)
        return wrappedText(
            "Keep a picture as A, then change settings: A and the new picture B are shown beside one "
            "another, "
            "with the error of one against the other. Both have the same random numbers, so what differs is "
            "due to the settings.");
    ImGui::Checkbox("Compare A with B (V)", &comparison.view.shown);
    if (comparison.view.shown) {
        drawModes(comparison.view);
        drawMetrics(comparison);
    }
    ImGui::Separator();
    drawSettingsOf(workspace, *comparison.a());
}

void drawComparisonMarks(const Workspace& workspace, glm::vec2 origin, glm::vec2 size) {
    const Comparison& comparison = workspace.comparison;
    if (!comparison.visible() || !workspace.view.traced || workspace.heat.shown) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Comparison::View& view = comparison.view;
    const auto mark = [&](const char* words, float x, bool leftOf) {
        pictureLabel(words, {x, origin.y + scaled(8.0f)}, leftOf);
    };
    draw.PushClipRect({origin.x, origin.y}, {origin.x + size.x, origin.y + size.y});
    const float x = origin.x + size.x * view.divider, gap = scaled(8.0f);
    if (view.mode == CompareMode::Wipe) {
        draw.AddLine({x, origin.y}, {x, origin.y + size.y}, IM_COL32(15, 17, 20, 200), scaled(4.0f));
        draw.AddLine({x, origin.y}, {x, origin.y + size.y}, IM_COL32(235, 237, 240, 255), scaled(2.0f));
        draw.AddCircleFilled({x, origin.y + 0.5f * size.y}, scaled(6.0f), IM_COL32(235, 237, 240, 255));
        mark("A", x - gap, true);
        mark("B", x + gap, false);
    } else if (view.mode == CompareMode::Flip) {
        mark(view.flipped ? "A" : "B", origin.x + gap, false);
    } else {
        mark(fmt::format("|A - B| x {:.3g}", view.brightness).c_str(), origin.x + gap, false);
    }
    draw.PopClipRect();
}

}  // namespace rayscope::viewer
