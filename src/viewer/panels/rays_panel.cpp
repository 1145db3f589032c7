// The recorded rays of a pixel: replay check, samples, diagnosis, legend and filters.
#include <fmt/format.h>

#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/ray_panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// A line in the style of the picture, in front of the text that follows.
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

/// The legend doubles as a filter: a click on a row shows or hides that kind of ray.
void drawLegend(DebugRayFilter& filter) {
    for (const RayLegendEntry& entry : debugRayLegend()) {
        bool& shown = filter.*entry.shown;
        drawLineSample(entry, shown);
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, shown ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : kDimText);
        if (ui::selectable(entry.label)) shown = !shown;
        ImGui::PopStyleColor();
    }
}

void drawFilter(Workspace& workspace) {
    DebugRayFilter& filter = workspace.rays.filter;
    labelledRow("Max depth", false, "Draw only rays with at most this many reflections before them.");
    ui::sliderInt("##depth", &filter.maxDepth, 0, 16, "%d", kClamp);
    labelledRow("Light", false, "Draw shadow rays to this light only, or to all.");
    const int lights = static_cast<int>(workspace.edit.scene->lights.size());
    filter.light = std::min(filter.light, lights - 1);
    ui::sliderInt("##light", &filter.light, -1, lights - 1, filter.light < 0 ? "all" : "%d", kClamp);
    labelledRow("Min contribution", false,
                "Hide rays that add less than this to the radiance of the sample.");
    ui::sliderFloat("##least", &filter.minContribution, 0.0f, 1.0f, "%.3g", ImGuiSliderFlags_Logarithmic);
    labelledRow("Colour", false,
                "kind: as in the legend. surface: the colour of the surface that is hit, lightened if it is "
                "dark, dashed if "
                "it is transparent. radiance: the radiance that arrives along the ray.");
    constexpr const char* kNames[] = {"kind", "surface", "radiance"};
    ui::combo("##colors", kNames[static_cast<int>(filter.colors)], [&] {
        for (int i = 0; i < 3; ++i)
            if (ui::selectable(kNames[i], static_cast<int>(filter.colors) == i))
                filter.colors = static_cast<RayColors>(i);
    });
}

/// Result of the replay: whether the recorded rays are those of the picture.
void drawReplay(const ReplayResult& replayResult) {
    if (replayResult.samples == 0) return dimText("Not compared with a picture");
    coloredText(replayResult.good() ? kGoodText : kErrorText,
                replayResult.good() ? fmt::format("Replay of {} samples: bit-identical", replayResult.samples)
                                    : "Replay differs from the picture");
    tooltip(
        "All samples of the pixel were traced again with the recorder. Bit-identical: their sum is that of "
        "the "
        "pixel of the picture, and the contributions of each ray tree add up to its radiance.");
    if (replayResult.good()) return;
    if (!replayResult.matchesFilm) {
        text(fmt::format("picture {} {} {}", replayResult.film.r, replayResult.film.g, replayResult.film.b));
        text(fmt::format("replay  {} {} {}", replayResult.replayed.r, replayResult.replayed.g,
                         replayResult.replayed.b));
    }
    if (!replayResult.sumMatches) text("contributions do not add up to the radiance");
}

void drawReplayProgress(DebugRays& rays) {
    dimText(fmt::format("replaying samples: {:.0f} %", 100.0 * rays.replayProgress()));
    ImGui::SameLine();
    if (ui::smallButton("Stop replay")) rays.cancelReplay();
}

void drawSamples(DebugRays& rays, const DebugRays::PixelRecording& recording) {
    int sample = recording.tree().name.index;
    labelledRow("Sample");
    if (ui::sliderInt("##sample", &sample, 0, std::max(0, recording.samples() - 1), "%d", kClamp))
        rays.selectSample(sample);
    tooltip("Sample of the pixel that the table lists.");
    bool all = rays.filter.allSamples;
    if (ui::checkbox("Draw all samples", &all)) rays.showAllSamples(all);
    if (!all) return;
    const std::string drawn = fmt::format("{} of {} drawn", recording.trees.size(), recording.samples());
    ImGui::SameLine();
    if (static_cast<int>(recording.trees.size()) < recording.samples())
        coloredText(kWarningText, drawn);
    else
        dimText(drawn);
    labelledRow("Memory limit", false, "Memory for the recorded rays.");
    int mebibytes = static_cast<int>(rays.budget >> 20);
    if (ui::sliderInt("##budget", &mebibytes, 1, 1024, "%d MiB", kClamp | ImGuiSliderFlags_Logarithmic)) {
        rays.budget = static_cast<std::size_t>(mebibytes) << 20;
        rays.showAllSamples(true);
    }
}

void drawRecording(Workspace& workspace, const DebugRays::PixelRecording& recording) {
    DebugRays& rays = workspace.rays;
    const RayTree& tree = recording.tree();
    text(fmt::format("Pixel {}, {}: {} rays, {} shadow rays", tree.name.x, tree.name.y, tree.nodes.size(),
                     tree.shadowRays.size()));
    ui::checkbox("Freeze", &rays.frozen);
    tooltip(
        "Keep these rays. Otherwise the pixel is recorded again after each change of the settings, the "
        "lights "
        "or the lens, from the camera position of the first recording.");
    ImGui::SameLine();
    if (rays.frozen && rays.isOutdated(workspace.edit))
        coloredText(kWarningText, "Frozen: the scene or a setting changed");
    else if (rays.frozen)
        dimText("Frozen");
    else
        dimText(rays.isOf(workspace.edit, workspace.imageSize()) ? "of this view" : "of an earlier view");
    if (rays.replaying())
        drawReplayProgress(rays);
    else if (recording.replayResult)
        drawReplay(*recording.replayResult);
    else
        dimText("Not compared with a picture");
    valueRow("Radiance", vectorText(tree.radiance));
    drawPixelSamples(workspace, recording);
    drawSamples(rays, recording);
    drawRayTable(workspace, recording);
}

/// Findings about the pixel, with buttons that select the rays that support them.
void drawDiagnosis(DebugRays& rays) {
    const std::vector<probe::Diagnosis>* diagnosis = rays.diagnose();
    if (diagnosis == nullptr) {
        if (rays.diagnosing()) {
            if (stoppableProgress(rays.diagnosisProgress())) rays.cancelDiagnosis();
        } else {
            if (!rays.diagnosisError().empty()) coloredText(kErrorText, rays.diagnosisError());
            if (ui::button("Diagnose", {-1.0f, 0.0f})) rays.restartDiagnosis();
        }
        return;
    }
    // A copy, because a click below selects another ray.
    const std::vector<probe::Diagnosis> all = *diagnosis;
    if (all.empty()) dimText("Nothing unusual about this pixel.");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const probe::Diagnosis& why = all[i];
        coloredText(kWarningText,
                    fmt::format("{}: {}", probe::nameOf(why.symptom), probe::nameOf(why.cause)));
        wrappedText(why.sentence);
        ImGui::PushID(static_cast<int>(i));
        for (std::size_t e = 0; e < std::min<std::size_t>(why.evidence.size(), 8); ++e) {
            if (e % 4 > 0) ImGui::SameLine();
            if (ui::smallButton(fmt::format("ray {}", e + 1).c_str())) rays.show(why.evidence[e]);
            tooltip("Select a ray that supports this finding.");
        }
        ImGui::PopID();
    }
}

}  // namespace

void drawRaysPanel(Workspace& workspace) {
    const DebugRays::PixelRecording* recording = workspace.rays.recording();
    if (ui::section("Recorded rays")) {
        if (recording != nullptr)
            drawRecording(workspace, *recording);
        else
            wrappedText("Point at a pixel and press R to record its rays, or:");
        if (ui::button("Record rays of a pixel...", {-1.0f, 0.0f}))
            workspace.commands.push_back(Command::RecordRays);
        tooltip("Then click a pixel of the picture.");
        ImGui::Spacing();
    }
    if (recording != nullptr && !workspace.view.liveRay && ui::section("Diagnosis"))
        drawDiagnosis(workspace.rays);
    if (recording != nullptr && ui::section("Traversal (T)")) drawTraversal(workspace);
    if (recording != nullptr && ui::section("Shading inputs")) drawSurface(workspace, *recording);
    if (ui::section("Legend (click to show or hide)")) drawLegend(workspace.rays.filter);
    if (ui::section("Filters")) drawFilter(workspace);
    if (ui::section("Pinned pixels")) drawPins(workspace);
}

}  // namespace rayscope::viewer
