#include <fmt/format.h>

#include "image/srgb.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"
#include "viewer/theme.h"

namespace rayscope::viewer {

namespace {

constexpr double kNoticeSeconds = 6.0;

std::string durationText(double seconds) {
    const int whole = static_cast<int>(seconds);
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    if (whole >= 10) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{:.1f} s", seconds);
}

const char* stateText(RenderState state) {
    switch (state) {
        case RenderState::Idle:
            return "idle";
        case RenderState::Compiling:
            return "preparing";
        case RenderState::Rendering:
            return "tracing";
        case RenderState::Paused:
            return "paused";
        case RenderState::Done:
            return "done";
        case RenderState::Failed:
            break;
    }
    return "failed";
}

void drawCursor(const CursorInfo& cursor) {
    dimText("pixel");
    ImGui::SameLine();
    text(fmt::format("{}, {}", cursor.pixel.x, cursor.pixel.y));
    if (cursor.radiance) {
        const Rgb& c = *cursor.radiance;
        ImGui::SameLine(0.0f, scaled(14.0f));
        dimText("rgb");
        ImGui::SameLine();
        text(fmt::format("{:.6g} {:.6g} {:.6g}", c.r, c.g, c.b));
    }
    ImGui::SameLine(0.0f, scaled(14.0f));
    if (cursor.object.empty())
        dimText("nothing");
    else if (cursor.triangle >= 0)
        text(fmt::format("{}, triangle {}", cursor.object, cursor.triangle));
    else
        text(cursor.object);
}

std::string progressText(const Workspace& workspace) {
    const RenderControl& render = workspace.render;
    const RenderStatus& status = render.status();
    std::string words =
        fmt::format("{}/{} samples   {:.2f} Mray/s   {}", status.samples, status.targetSamples,
                    render.raysPerSecond() * 1e-6, durationText(status.elapsedSeconds));
    if (status.state == RenderState::Rendering && status.remainingSeconds > 0.0)
        words += fmt::format("   ETA {}", durationText(status.remainingSeconds));
    return words + fmt::format("   {}", stateText(status.state));
}

void drawProgress(const Workspace& workspace) {
    const RenderStatus& status = workspace.render.status();
    const std::string words = progressText(workspace);
    const std::string bad = fmt::format("NaN {}", status.nonFiniteSamples);
    const float gap = scaled(14.0f),
                width = ImGui::CalcTextSize(words.c_str()).x + ImGui::CalcTextSize(bad.c_str()).x + gap;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x);
    text(words);
    ImGui::SameLine(0.0f, gap);
    if (status.nonFiniteSamples > 0)
        coloredText(kErrorText, bad);
    else
        dimText(bad);
    tooltip("Samples that are not a number or infinite. They are left out of the picture and counted here.");

    const ImVec2 at = ImGui::GetWindowPos();
    const float done = ImGui::GetWindowWidth() * static_cast<float>(status.progress);
    if (status.state == RenderState::Rendering || status.state == RenderState::Paused)
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + done, at.y + scaled(2.0f)},
                                                  ImGui::GetColorU32(ImGuiCol_PlotHistogram));
}

bool isFresh(const Notice& notice) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - notice.at).count() <
           kNoticeSeconds;
}

}  // namespace

void drawStatusBar(Workspace& workspace, float height) {
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({viewport.Pos.x, viewport.Pos.y + viewport.Size.y - height});
    ImGui::SetNextWindowSize({viewport.Size.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(10.0f), scaled(5.0f)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("##status", nullptr, kFlags)) {
        const std::optional<Notice>& notice = workspace.notice;
        if (workspace.loader.busy())
            text("opening " + workspace.loader.path() + " ...");
        else if (notice && isFresh(*notice))
            coloredText(notice->severity == Severity::Note ? kGoodText : kWarningText, notice->text);
        else if (workspace.render.status().state == RenderState::Failed)
            coloredText(kErrorText, workspace.render.status().message);
        else if (workspace.view.flying)
            text(fmt::format("fly: W A S D Q E, wheel: speed {:.3g} units/s, Esc: end",
                             workspace.view.flySpeed));
        else if (workspace.cursor)
            drawCursor(*workspace.cursor);
        else
            dimText("F1 lists the keys");
        drawProgress(workspace);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

}  // namespace rayscope::viewer
