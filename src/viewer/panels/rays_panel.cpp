// What was recorded of a pixel: samples, the proof that they are those of the picture, and the legend.
#include <fmt/format.h>

#include "probe/names.h"
#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/ray_panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;

ImU32 toU32(glm::vec4 c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, c.w}); }

/// A piece of line as it looks in the picture, on the line of text that follows.
void drawLineSample(const RayLegendEntry& entry, bool shown) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + 0.5f * ImGui::GetTextLineHeight(), length = scaled(26.0f);
    const float dash = entry.style == LineStyle::Solid    ? length
                       : entry.style == LineStyle::Dashed ? scaled(6.0f)
                                                          : scaled(2.0f);
    glm::vec4 color = entry.color;
    if (!shown) color.a *= 0.25f;
    for (float x = 0.0f; x < length; x += 1.7f * dash)
        ImGui::GetWindowDrawList()->AddLine({at.x + x, y}, {at.x + std::min(x + dash, length), y},
                                            toU32(color), scaled(2.0f));
    ImGui::Dummy({length, ImGui::GetTextLineHeight()});
}

/// The legend is the filter: a click on a row shows or hides what it stands for.
void drawLegend(DebugRayFilter& filter) {
    for (const RayLegendEntry& entry : debugRayLegend()) {
        bool& shown = filter.*entry.shown;
        drawLineSample(entry, shown);
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, shown ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : kDimText);
        if (ImGui::Selectable(entry.label)) shown = !shown;
        ImGui::PopStyleColor();
    }
}

void drawFilter(Workspace& workspace) {
    DebugRayFilter& filter = workspace.rays.filter;
    labelledRow("Depth up to", false, "Rays after more reflections than this are not drawn.");
    ImGui::SliderInt("##depth", &filter.maxDepth, 0, 16, "%d", kClamp);
    labelledRow("Light", false, "Shadow rays to one light, or to all.");
    const int lights = static_cast<int>(workspace.edit.scene->lights.size());
    filter.light = std::min(filter.light, lights - 1);
    ImGui::SliderInt("##light", &filter.light, -1, lights - 1, filter.light < 0 ? "all" : "%d", kClamp);
    labelledRow("Adds at least", false, "Hides what adds less than this to the radiance of the sample.");
    ImGui::SliderFloat("##least", &filter.minContribution, 0.0f, 1.0f, "%.3g", ImGuiSliderFlags_Logarithmic);
    labelledRow(
        "Colour", false,
        "By kind as in the legend; in what the surface at the end of the ray shows of its own, thin where "
        "it lets light through; or in the light that comes along the ray.");
    constexpr const char* kNames[] = {"kind", "surface", "arriving light"};
    int colors = static_cast<int>(filter.colors);
    if (ImGui::Combo("##colors", &colors, kNames, 3)) filter.colors = static_cast<RayColors>(colors);
    if (!filter.hidden.empty() &&
        ImGui::Button(fmt::format("Show {} hidden rays", filter.hidden.size()).c_str(), {-1.0f, 0.0f}))
        filter.hidden.clear();
}

std::string rgbText(const RgbSum& c) { return fmt::format("{:.4g}  {:.4g}  {:.4g}", c.r, c.g, c.b); }

/// The proof that the rays shown are those of the picture.
void drawVerdict(const ReplayResult& verdict) {
    if (verdict.samples == 0) return;
    coloredText(verdict.good() ? kGoodText : kErrorText,
                verdict.good() ? fmt::format("[x] replay of {} samples: same bits", verdict.samples)
                               : "[ ] the replay differs from the picture");
    tooltip(
        "All samples of the pixel were traced again with the recorder. The tick says that their sum has the "
        "same bits as the picture's, and that the contributions in every tree add up to its radiance.");
    if (verdict.good()) return;
    if (!verdict.matchesFilm) {
        text(fmt::format("picture {} {} {}", verdict.film.r, verdict.film.g, verdict.film.b));
        text(fmt::format("replay  {} {} {}", verdict.replayed.r, verdict.replayed.g, verdict.replayed.b));
    }
    if (!verdict.sumMatches) text("the contributions of a tree do not add up to its radiance");
}

void drawReplayProgress(DebugRays& rays) {
    dimText(fmt::format("replaying samples: {:.0f} %", 100.0 * rays.replayProgress()));
    ImGui::SameLine();
    if (ImGui::SmallButton("Stop")) rays.cancelReplay();
}

void drawSamples(DebugRays& rays, const DebugRays::PixelRecording& recording) {
    int sample = recording.tree().name.index;
    labelledRow("Sample");
    if (ImGui::SliderInt("##sample", &sample, 0, std::max(0, recording.samples - 1), "%d", kClamp))
        rays.selectSample(sample);
    tooltip("Which sample of the pixel the table lists.");
    bool all = rays.filter.allSamples;
    if (ImGui::Checkbox("Draw all samples", &all)) rays.showAllSamples(all);
    if (!all) return;
    const std::string words = fmt::format("{} of {} shown", recording.trees.size(), recording.samples);
    ImGui::SameLine();
    if (static_cast<int>(recording.trees.size()) < recording.samples)
        coloredText(kWarningText, words);
    else
        dimText(words);
    labelledRow("Budget", false, "How much memory the recorded rays may take.");
    int mebibytes = static_cast<int>(rays.budget >> 20);
    if (ImGui::SliderInt("##budget", &mebibytes, 1, 1024, "%d MiB", kClamp | ImGuiSliderFlags_Logarithmic)) {
        rays.budget = static_cast<std::size_t>(mebibytes) << 20;
        rays.showAllSamples(true);
    }
}

void drawRecording(Workspace& workspace, const DebugRays::PixelRecording& recording) {
    DebugRays& rays = workspace.rays;
    const RayTree& tree = recording.tree();
    text(fmt::format("Pixel {}, {}: {} rays, {} shadow rays", tree.name.x, tree.name.y, tree.nodes.size(),
                     tree.shadowRays.size()));
    if (rays.isStaleFor(workspace.edit, workspace.imageSize()))
        coloredText(kWarningText, "Stale: something has changed since");
    if (rays.replaying())
        drawReplayProgress(rays);
    else if (recording.verdict)
        drawVerdict(*recording.verdict);
    valueRow("Radiance", rgbText(tree.radiance));
    drawPixelSamples(workspace, recording);
    drawSamples(rays, recording);
    drawRayTable(workspace, recording);
}

/// Sentences about the pixel; a click goes to a ray that they rest on.
void drawDiagnosis(DebugRays& rays) {
    const std::vector<probe::Diagnosis>* diagnosis = rays.diagnose();
    if (diagnosis == nullptr) {
        if (rays.diagnosing()) {
            if (stoppableProgress(rays.diagnosisProgress())) rays.cancelDiagnosis();
        } else {
            if (!rays.diagnosisError().empty()) coloredText(kErrorText, rays.diagnosisError());
            if (ImGui::Button("Diagnose", {-1.0f, 0.0f})) rays.restartDiagnosis();
        }
        return;
    }
    // A copy, because a click below selects another ray.
    const std::vector<probe::Diagnosis> all = *diagnosis;
    if (all.empty()) dimText("Nothing stands out about this pixel.");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const probe::Diagnosis& why = all[i];
        coloredText(kWarningText,
                    fmt::format("{}: {}", probe::nameOf(why.symptom), probe::nameOf(why.cause)));
        wrappedText(why.sentence);
        ImGui::PushID(static_cast<int>(i));
        for (std::size_t e = 0; e < std::min<std::size_t>(why.evidence.size(), 8); ++e) {
            if (e % 4 > 0) ImGui::SameLine();
            if (ImGui::SmallButton(fmt::format("ray {}", e + 1).c_str())) rays.show(why.evidence[e]);
            tooltip("Go to a ray that this rests on.");
        }
        ImGui::PopID();
    }
}

}  // namespace

void drawRaysPanel(Workspace& workspace) {
    const auto section = [](const char* name) {
        return ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    };
    const DebugRays::PixelRecording* recording = workspace.rays.recording();
    if (section("Recorded rays")) {
        if (recording != nullptr)
            drawRecording(workspace, *recording);
        else
            wrappedText("Point at a pixel and press R: its rays are recorded, drawn and listed here.");
        ImGui::Spacing();
    }
    if (recording != nullptr && !workspace.view.liveRay && section("Why is it so?"))
        drawDiagnosis(workspace.rays);
    if (recording != nullptr && section("Search (T)")) drawTraversal(workspace);
    if (recording != nullptr && section("Where it ends")) drawSurface(workspace, *recording);
    if (section("Legend: click to show or hide")) drawLegend(workspace.rays.filter);
    if (section("Shown")) drawFilter(workspace);
    if (section("Pinned pixels")) drawPins(workspace);
}

}  // namespace rayscope::viewer
