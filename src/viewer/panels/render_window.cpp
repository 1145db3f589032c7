#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>
#include <utility>

#include "base/duration_text.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kRenderTitle = "Render to file";

/// With its folder.
std::string fullPath(const std::string& path) {
    std::error_code failed;
    const std::filesystem::path full = std::filesystem::absolute(path, failed);
    return failed ? path : full.lexically_normal().string();
}

bool exists(const std::string& path) {
    std::error_code failed;
    return std::filesystem::exists(path, failed) && !failed;
}

void drawOutcome(const RenderJob& job) {
    switch (job.phase()) {
        case RenderJob::Phase::Done:
            ImGui::PushStyleColor(ImGuiCol_Text, kGoodText);
            wrappedText("Written: " + fullPath(job.path()));
            ImGui::PopStyleColor();
            break;
        case RenderJob::Phase::Cancelled:
            coloredText(kWarningText, "Cancelled: no file written.");
            break;
        case RenderJob::Phase::Failed:
            ImGui::PushStyleColor(ImGuiCol_Text, kErrorText);
            wrappedText(job.error());
            ImGui::PopStyleColor();
            break;
        default:
            break;
    }
}

}  // namespace

void RenderWindow::request(Workspace& workspace) {
    workspace.view.showRenderWindow = true;
    if (workspace.job && workspace.job->running()) return;
    size_[0] = workspace.imageSize().x;
    size_[1] = workspace.imageSize().y;
    samples_ = workspace.edit.settings.spp;
    errorMessage_.clear();
    overwritten_.clear();
    workspace.job.reset();
}

void RenderWindow::start(Workspace& workspace) {
    EditState state = workspace.edit;
    state.settings.spp = samples_;
    errorMessage_.clear();
    overwritten_.clear();
    try {
        workspace.job.reset();
        workspace.job =
            std::make_unique<RenderJob>(state, size_[0], size_[1], path_, workspace.render.threads());
        running_ = true;
    } catch (const InputError& error) {
        errorMessage_ = error.what();
    }
}

/// Messages are below the buttons, which therefore stay where they are.
void RenderWindow::drawForm(Workspace& workspace) {
    labelledRow("Size in pixels");
    ui::noted("##size", ImGui::InputInt2("##size", size_));
    labelledRow("Samples per pixel");
    ui::noted("##samples", ImGui::InputInt("##samples", &samples_, 0));
    labelledRow("File (.png .exr .pfm .hdr .ppm .pgm)");
    if (ui::noted("##file", ImGui::InputText("##file", &path_))) overwritten_.clear();
    for (int& side : size_) side = std::clamp(side, 1, 32768);
    samples_ = std::clamp(samples_, 1, 1 << 20);
    ImGui::Spacing();
    if (ui::button("Render", {scaled(110.0f), 0.0f}) || enterPressed()) {
        if (exists(path_))
            overwritten_ = path_;
        else
            start(workspace);
    }
    ImGui::SameLine();
    if (ui::button("Close", {scaled(110.0f), 0.0f}) || workspace.closeDialogs)
        workspace.view.showRenderWindow = false;
    if (!overwritten_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kWarningText);
        wrappedText(fullPath(overwritten_) + " exists.");
        ImGui::PopStyleColor();
        if (ui::button("Overwrite", {scaled(110.0f), 0.0f})) start(workspace);
        ImGui::SameLine();
        if (ui::button("Keep", {scaled(110.0f), 0.0f})) overwritten_.clear();
    } else if (!errorMessage_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kErrorText);
        wrappedText(errorMessage_);
        ImGui::PopStyleColor();
    } else if (workspace.job) {
        drawOutcome(*workspace.job);
    } else if (std::filesystem::path(path_).is_relative()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
        wrappedText("Will be written to " + fullPath(path_));
        ImGui::PopStyleColor();
    }
}

void RenderWindow::drawProgress(Workspace& workspace) {
    const RenderJob& job = *workspace.job;
    const RenderStatus status = job.status();
    wrappedText(fmt::format("{} x {} pixels to {}", size_[0], size_[1], fullPath(job.path())));
    const std::string label = job.phase() == RenderJob::Phase::Writing
                                  ? std::string("writing")
                                  : fmt::format("{:.0f} %", 100.0 * status.progress);
    ImGui::ProgressBar(static_cast<float>(status.progress), {-1.0f, 0.0f}, label.c_str());
    text(fmt::format("{} of {} samples, {}, {}", status.samples, status.targetSamples,
                     base::durationText(status.elapsedSeconds),
                     status.remainingSeconds > 0.0 ? base::durationText(status.remainingSeconds) + " left"
                                                   : std::string("estimating")));
    ImGui::Spacing();
    if (ui::button("Cancel", {scaled(110.0f), 0.0f})) workspace.job->cancel();
    ImGui::SameLine();
    if (ui::button("Hide", {scaled(110.0f), 0.0f})) workspace.view.showRenderWindow = false;
    tooltip("Close this window and go on rendering; the status bar shows the progress.");
}

/// The end of a render whose window is closed.
void RenderWindow::reportEnd(Workspace& workspace) {
    const RenderJob& job = *workspace.job;
    if (job.phase() == RenderJob::Phase::Done) workspace.notify("Written: " + fullPath(job.path()));
    if (job.phase() == RenderJob::Phase::Failed) workspace.errorMessage = job.error();
}

void RenderWindow::draw(Workspace& workspace) {
    const bool running = workspace.job && workspace.job->running();
    bool& shown = workspace.view.showRenderWindow;
    if (std::exchange(running_, running) && !running && workspace.job && !shown) reportEnd(workspace);
    if (!shown) {
        if (!running) workspace.job.reset();
        return;
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.37f, display.y * 0.4f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(scaled(460.0f), display.x * 0.9f), 0.0f});
    if (ImGui::Begin(kRenderTitle, &shown, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse)) {
        const ui::Scope scope(kRenderTitle);
        if (running)
            drawProgress(workspace);
        else
            drawForm(workspace);
    }
    ImGui::End();
}

}  // namespace rayscope::viewer
