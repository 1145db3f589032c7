// Comparison of a kept picture A with the current picture B.
#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawModes(Comparison::View& view) {
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    const auto button = [&](const char* label, CompareMode mode, const char* help) {
        if (toggleButton(label, view.mode == mode, third)) view.mode = mode;
        tooltip(help);
    };
    button("Wipe", CompareMode::Wipe, "A left of a divider that can be dragged, B right of it.");
    ImGui::SameLine();
    button("Flip", CompareMode::Flip, "A or B; X switches.");
    ImGui::SameLine();
    button("Difference", CompareMode::Difference, "Absolute difference of each channel, scaled.");
    if (view.mode == CompareMode::Wipe) {
        labelledRow("Divider", false, "Or drag the divider in the picture.");
        ui::sliderFloat("##divider", &view.divider, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    } else if (view.mode == CompareMode::Flip) {
        labelledRow("Shown (X)");
        const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
        if (toggleButton("A", view.flipped, half)) view.flipped = true;
        ImGui::SameLine();
        if (toggleButton("B", !view.flipped, half)) view.flipped = false;
    } else {
        labelledRow("Scale", false, "Factor on the differences.");
        ui::sliderFloat("##brightness", &view.brightness, 0.1f, 1000.0f, "%.3g",
                        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    }
}

void drawMetrics(const Comparison& comparison) {
    const ErrorMeasures* metrics = comparison.metrics();
    if (metrics == nullptr)
        return dimText(comparison.busy() ? "measuring ..." : "A and B differ in size: no metrics");
    valueRow("RMSE", fmt::format("{:.6g}", metrics->rmse),
             "Root mean squared difference of the linear values.");
    valueRow("Largest",
             fmt::format("{:.4g} at {}, {}", metrics->maximum, metrics->maximumX, metrics->maximumY),
             "Largest difference of a channel, linear, and its pixel.");
    valueRow("SSIM", fmt::format("{:.6f}", metrics->ssim),
             "Structural similarity of the displayed luminance; 1 for equal pictures.");
    valueRow("FLIP", fmt::format("{:.6f}", metrics->flip),
             "Mean perceived difference on a display; 0 for equal pictures.");
    if (comparison.metricsAreFinal())
        dimText("complete picture B against A");
    else
        dimText(comparison.busy() ? "preliminary; measuring ..." : "preliminary: B is not complete yet");
}

void drawSettingsOf(Workspace& workspace, const Comparison::Kept& a) {
    dimText(fmt::format("A: {} samples per pixel, {} x {}", samplesText(a.picture), a.image->width,
                        a.image->height));
    if (const RenderRequest* b = workspace.shown.request()) {
        dimText(fmt::format("B: {} of {} samples per pixel, {} x {}", workspace.shown.leastSamples(),
                            b->settings.spp, b->width, b->height));
        if (const std::string notice = tracedNotice(workspace); !notice.empty()) text("B: " + notice);
        const std::vector<std::string> differences = differencesOf(a.picture.request(), *b);
        if (differences.empty()) dimText("B has the same settings as A: change some.");
        for (const std::string& difference : differences) text(difference);
    }
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ui::button("Restore settings", {half, 0.0f})) workspace.edit.settings = a.picture.request().settings;
    tooltip("Set B to the settings of A; can be undone.");
    ImGui::SameLine();
    if (ui::button("Discard A", {half, 0.0f})) workspace.comparison.discard();
}

}  // namespace

void drawComparisonPanel(Workspace& workspace) {
    Comparison& comparison = workspace.comparison;
    if (ui::button("Keep the traced picture as A (K)", {-1.0f, 0.0f}))
        workspace.commands.push_back(Command::KeepPicture);
    tooltip("With its settings. Then change settings: the new picture B uses the same random numbers.");
    if (comparison.a() == nullptr)
        return wrappedText(
            "Keep a picture as A, then change settings: A and the new picture B are shown side by side, with "
            "the error of B against A. Both use the same random numbers, so all differences are due to the "
            "settings.");
    ui::checkbox("Compare A with B (V)", &comparison.view.shown);
    if (comparison.view.shown) {
        drawModes(comparison.view);
        drawMetrics(comparison);
    }
    ImGui::Separator();
    drawSettingsOf(workspace, *comparison.a());
}

void drawTracedNotice(const Workspace& workspace, glm::vec2 origin) {
    const std::string notice = tracedNotice(workspace);
    // Below the marks of compared pictures.
    const float y = origin.y + scaled(8.0f) + 2.0f * ImGui::GetTextLineHeight();
    if (!notice.empty()) pictureLabel(notice.c_str(), {origin.x + scaled(8.0f), y});
}

void drawComparisonMarks(const Workspace& workspace, glm::vec2 origin, glm::vec2 size) {
    const Comparison& comparison = workspace.comparison;
    if (!comparison.visible() || !workspace.view.traced || workspace.heat.shown) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Comparison::View& view = comparison.view;
    const auto mark = [&](const char* content, float x, bool leftOf) {
        pictureLabel(content, {x, origin.y + scaled(8.0f)}, leftOf);
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
