#include <fmt/format.h>

#include <algorithm>

#include "base/duration_text.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr double kNoticeSeconds = 6.0;

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
        text(vectorText(glm::dvec3(c)));
        tooltip("Linear red, green and blue of the picture at this pixel. Ctrl+C copies all digits.");
    }
    ImGui::SameLine(0.0f, scaled(14.0f));
    if (cursor.object.empty())
        dimText("nothing");
    else if (cursor.triangle >= 0)
        text(fmt::format("{}, triangle {}", cursor.object, cursor.triangle));
    else
        text(cursor.object);
}

/// Estimated error, and when the target will be reached or what error the time limit will leave.
std::string errorText(const Workspace& workspace) {
    const std::optional<ErrorForecast> forecast = workspace.render.forecast();
    if (!forecast || !workspace.view.traced) return "";
    const StopCriteria& stopCriteria = workspace.stopCriteria;
    std::string status = fmt::format("error {:.2g}   ", forecast->estimate.error);
    if (workspace.render.status().state != RenderState::Rendering) return status;
    if (stopCriteria.byError && forecast->remainingSeconds > 0.0)
        status += fmt::format("{:.2g} in {}   ", stopCriteria.error,
                              base::durationText(forecast->remainingSeconds));
    if (stopCriteria.byTime)
        status += fmt::format("{:.2g} at {}   ", forecast->errorAtLimit,
                              base::durationText(static_cast<double>(stopCriteria.seconds)));
    return status;
}

std::string endText(const RenderControl& render) {
    if (!render.stopReason()) return stateText(render.status().state);
    return *render.stopReason() == StopReason::Reached ? "target reached" : "time limit";
}

std::string progressText(const Workspace& workspace) {
    const RenderControl& render = workspace.render;
    const RenderStatus& status = render.status();
    // In the rasterised view the world is only prepared for rays to be recorded.
    if (!workspace.view.traced) return render.busy() ? "preparing" : "rasterised";
    const bool openEnded = workspace.stopCriteria.byError;
    std::string progress = openEnded ? fmt::format("{} samples   ", status.samples)
                                     : fmt::format("{}/{} samples   ", status.samples, status.targetSamples);
    progress += fmt::format("{:.2f} Mray/s   {}   ", render.raysPerSecond() * 1e-6,
                            base::durationText(status.elapsedSeconds));
    if (status.state == RenderState::Rendering && status.remainingSeconds > 0.0 && !openEnded)
        progress += fmt::format("{} left   ", base::durationText(status.remainingSeconds));
    return progress + errorText(workspace) + endText(render);
}

/// The estimated fraction of the work that is done, 0 to 1.
double doneShare(const Workspace& workspace) {
    const RenderStatus& status = workspace.render.status();
    const std::optional<ErrorForecast> forecast = workspace.render.forecast();
    double fraction = workspace.stopCriteria.byError ? 0.0 : status.progress;
    if (workspace.stopCriteria.byError && forecast && forecast->remainingSeconds > 0.0)
        fraction = status.elapsedSeconds / (status.elapsedSeconds + forecast->remainingSeconds);
    if (workspace.stopCriteria.byTime)
        fraction =
            std::max(fraction, status.elapsedSeconds / static_cast<double>(workspace.stopCriteria.seconds));
    return std::min(fraction, 1.0);
}

/// Empty if all samples are finite.
std::string nonFiniteText(const Workspace& workspace) {
    const auto count = workspace.render.status().nonFiniteSamples;
    return count > 0 && workspace.view.traced ? fmt::format("NaN {}", count) : "";
}

/// The text at the right end of the bar.
struct Progress {
    std::string content, nonFinite;
    float gap = scaled(14.0f);

    explicit Progress(const Workspace& workspace)
        : content(progressText(workspace)), nonFinite(nonFiniteText(workspace)) {}
    /// Distance from the left edge of the window.
    float start() const {
        float width = ImGui::CalcTextSize(content.c_str()).x;
        if (!nonFinite.empty()) width += ImGui::CalcTextSize(nonFinite.c_str()).x + gap;
        return ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
    }
};

void drawProgress(const Workspace& workspace, const Progress& progress) {
    const RenderStatus& status = workspace.render.status();
    ImGui::SameLine(progress.start());
    text(progress.content);
    tooltip("Samples per pixel, rays per second, time so far, time left.");
    if (!progress.nonFinite.empty()) {
        ImGui::SameLine(0.0f, progress.gap);
        coloredText(kErrorText, progress.nonFinite);
        tooltip("Samples that are NaN or infinite. Their pixels are NaN and shown in magenta.");
    }

    const ImVec2 at = ImGui::GetWindowPos();
    // Visible from the start.
    const float done =
        std::max(scaled(10.0f), ImGui::GetWindowWidth() * static_cast<float>(doneShare(workspace)));
    if (workspace.render.busy() || workspace.comparison.busy() || status.state == RenderState::Paused)
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + done, at.y + scaled(2.0f)},
                                                  ImGui::GetColorU32(ImGuiCol_PlotHistogram));
}

std::string loadingText(const SceneLoader& loader) {
    const SceneLoader::Step step = loader.step();
    if (step.name.empty()) return fmt::format("loading {} ...", loader.path());
    return fmt::format("loading {}: {}, {:.0f} %", loader.path(), step.name, 100.0 * step.fraction);
}

std::string renderingText(const RenderJob& job) {
    const RenderStatus status = job.status();
    const std::string left =
        status.remainingSeconds > 0.0 ? ", " + base::durationText(status.remainingSeconds) + " left" : "";
    return fmt::format("rendering {}: {:.0f} %{}", job.path(), 100.0 * status.progress, left);
}

bool isFresh(const Notice& notice) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - notice.at).count() <
           kNoticeSeconds;
}

}  // namespace

void drawDetailNotice(const DrawnCounts& counts, glm::vec2 origin, glm::vec2 size) {
    const std::string drawn = drawnText(counts);
    if (drawn.empty()) return;
    const float height = ImGui::GetFontSize() + scaled(12.0f);
    pictureLabel(("drawn: " + drawn).c_str(), {origin.x + scaled(8.0f), origin.y + size.y - height});
}

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
        const ui::Scope scope("Status bar");
        const Progress progress(workspace);
        const ImVec2 corner = ImGui::GetWindowPos();
        ImGui::PushClipRect(corner, {corner.x + progress.start() - progress.gap, corner.y + height}, true);
        const std::optional<Notice>& notice = workspace.notice;
        if (workspace.loader.loading())
            text(loadingText(workspace.loader));
        else if (const std::string saving = workspace.saves.current(); !saving.empty())
            text(fmt::format("saving {} ...", saving));
        else if (notice && isFresh(*notice))
            coloredText(notice->severity == Severity::Note ? kGoodText : kWarningText, notice->text);
        else if (workspace.render.status().state == RenderState::Failed)
            coloredText(kErrorText, workspace.render.status().message);
        else if (workspace.job && workspace.job->running() && !workspace.view.showRenderWindow)
            text(renderingText(*workspace.job));
        else if (workspace.view.picking)
            text(fmt::format("{}: click a pixel of the picture, Esc cancels",
                             infoOf(*workspace.view.picking).label));
        else if (workspace.view.flying)
            text(fmt::format(
                "fly mode: W A S D Q E to move, wheel for the speed ({:.3g} units/s), Esc to leave",
                workspace.view.flySpeed));
        else if (workspace.cursor)
            drawCursor(*workspace.cursor);
        else
            dimText("F1: keys and gestures");
        ImGui::PopClipRect();
        drawProgress(workspace, progress);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

}  // namespace rayscope::viewer
