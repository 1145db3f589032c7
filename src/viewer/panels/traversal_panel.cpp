#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/ray_panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// The step that was taken last, the interval in which hits still count, and what waits.
void drawStep(const probe::TraversalLog& log, std::size_t steps) {
    const probe::TraversalState state = probe::stateAfter(log, steps);
    if (steps > 0) {
        const probe::TraversalStep& step = log.steps[steps - 1];
        const std::string distance = std::isnan(step.t) ? "" : fmt::format(" at t {:.6g}", step.t);
        text(probe::describe(log, step) + distance);
    } else {
        dimText("before the first step");
    }
    valueRow("Hits count", fmt::format("{:.4g} < t <= {:.6g}", log.ray.tMin, state.bound));
    labelledRow("Stack");
    if (state.stack.empty()) return dimText("empty");
    std::string words;
    constexpr std::size_t kNamed = 4;
    for (std::size_t i = 0; i < std::min(kNamed, state.stack.size()); ++i) {
        const probe::TraversalState::StackEntry& waiting = state.stack[state.stack.size() - 1 - i];
        words += fmt::format("{}{} at {:.4g}", i > 0 ? "\n" : "", log.boxes[waiting.box].node, waiting.t);
    }
    if (state.stack.size() > kNamed) words += fmt::format("\nand {} more", state.stack.size() - kNamed);
    text(words);
}

void drawLog(DebugRays& rays, const probe::TraversalLog& log) {
    ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
    wrappedText(probe::summary(log));
    ImGui::PopStyleColor();
    ImGui::Checkbox("Step by step", &rays.traversal.stepping);
    if (!rays.traversal.stepping) return;
    const int steps = static_cast<int>(log.steps.size());
    rays.traversal.step = std::clamp(rays.traversal.step, 0, steps);
    labelledRow("Step", false, "The arrow keys to the left and right take one, with Shift ten.");
    ImGui::SliderInt("##step", &rays.traversal.step, 0, steps, fmt::format("%d of {}", steps).c_str(),
                     ImGuiSliderFlags_AlwaysClamp);
    drawStep(log, static_cast<std::size_t>(rays.traversal.step));
}

/// The trees are searched in other steps; the place in the traversal would mean nothing in the other one.
void drawLayoutChoice(TraversalOverlayOptions& traversal) {
    labelledRow("Tree", false,
                "The binary tree, as the panel BVH shows it, or the one with eight children per node that "
                "production rays walk.");
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    const BvhLayout before = traversal.layout;
    if (toggleButton("Binary", before == BvhLayout::Binary, half)) traversal.layout = BvhLayout::Binary;
    ImGui::SameLine();
    if (toggleButton("Wide", before == BvhLayout::Wide, half)) traversal.layout = BvhLayout::Wide;
    if (traversal.layout != before) traversal.step = 0;
}

}  // namespace

void drawTraversal(Workspace& workspace) {
    DebugRays& rays = workspace.rays;
    ImGui::Checkbox("Draw", &rays.traversal.shown);
    tooltip("The search of the selected ray through the BVH, else of the first camera ray (T).");
    ImGui::SameLine();
    ImGui::Checkbox("Skipped", &rays.traversal.culled);
    tooltip("Boxes that the ray meets, but behind a hit that was found before.");
    ImGui::SameLine();
    ImGui::Checkbox("Missed", &rays.traversal.missed);
    tooltip("Boxes that were tested and are not on the ray.");
    if (!rays.traversal.shown) return;
    drawLayoutChoice(rays.traversal);
    if (rays.traversals().empty())
        return wrappedText(rays.traversal.layout == BvhLayout::Wide
                               ? "There is no wide tree to search: see the setting bvh_layout."
                               : "There is no hierarchy to search.");
    for (const probe::TraversalLog& log : rays.traversals()) {
        ImGui::PushID(static_cast<int>(log.motionGroup));
        if (rays.traversals().size() > 1) dimText(fmt::format("body {}", log.motionGroup));
        drawLog(rays, log);
        ImGui::PopID();
    }
}

}  // namespace rayscope::viewer
