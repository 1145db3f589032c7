#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kRenderTitle = "Render to file";

void drawOutcome(const RenderJob& job) {
    switch (job.phase()) {
        case RenderJob::Phase::Done:
            coloredText(kGoodText, "Written: " + job.path());
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

void RenderDialog::drawForm(Workspace& workspace) {
    labelledRow("Size in pixels");
    ui::noted("##size", ImGui::InputInt2("##size", size_));
    labelledRow("Samples per pixel");
    ui::noted("##samples", ImGui::InputInt("##samples", &samples_, 0));
    labelledRow("File (.png .exr .pfm .hdr .ppm .pgm)");
    ui::noted("##file", ImGui::InputText("##file", &path_));
    for (int& side : size_) side = std::clamp(side, 1, 32768);
    samples_ = std::clamp(samples_, 1, 1 << 20);
    if (!errorMessage_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, kErrorText);
        wrappedText(errorMessage_);
        ImGui::PopStyleColor();
    }
    if (workspace.job) drawOutcome(*workspace.job);
    ImGui::Spacing();
    const bool entered =
        !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
    if (ui::button("Render", {scaled(110.0f), 0.0f}) || entered) {
        EditState state = workspace.edit;
        state.settings.spp = samples_;
        try {
            workspace.job.reset();
            workspace.job =
                std::make_unique<RenderJob>(state, size_[0], size_[1], path_, workspace.render.threads());
            errorMessage_.clear();
        } catch (const InputError& error) {
            errorMessage_ = error.what();
        }
    }
    ImGui::SameLine();
    if (ui::button("Close", {scaled(110.0f), 0.0f}) || workspace.closeDialogs) {
        workspace.job.reset();
        ImGui::CloseCurrentPopup();
    }
}

void RenderDialog::drawProgress(Workspace& workspace) {
    const RenderJob& job = *workspace.job;
    const RenderStatus status = job.status();
    text(fmt::format("{} x {} pixels to {}", size_[0], size_[1], job.path()));
    const std::string label = job.phase() == RenderJob::Phase::Writing
                                  ? std::string("writing")
                                  : fmt::format("{:.0f} %", 100.0 * status.progress);
    ImGui::ProgressBar(static_cast<float>(status.progress), {-1.0f, 0.0f}, label.c_str());
    text(fmt::format("{} of {} samples, {:.1f} s, {}", status.samples, status.targetSamples,
                     status.elapsedSeconds,
                     status.remainingSeconds > 0.0 ? fmt::format("{:.1f} s left", status.remainingSeconds)
                                                   : std::string("estimating")));
    ImGui::Spacing();
    if (ui::button("Cancel", {scaled(110.0f), 0.0f}) || workspace.closeDialogs) workspace.job->cancel();
}

void RenderDialog::draw(Workspace& workspace) {
    if (std::exchange(requested_, false)) {
        size_[0] = workspace.imageSize().x;
        size_[1] = workspace.imageSize().y;
        samples_ = workspace.edit.settings.spp;
        errorMessage_.clear();
        ImGui::OpenPopup(kRenderTitle);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.45f}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(scaled(460.0f), display.x * 0.9f), 0.0f});
    if (!ImGui::BeginPopupModal(kRenderTitle, nullptr, ImGuiWindowFlags_NoResize)) return;
    const ui::Scope scope(kRenderTitle);
    if (workspace.job && workspace.job->running())
        drawProgress(workspace);
    else
        drawForm(workspace);
    ImGui::EndPopup();
}

}  // namespace rayscope::viewer
