#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/panels/ray_panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// The last step, the interval in which hits are accepted, and the traversal stack.
void drawStep(const probe::TraversalLog& log, std::size_t steps) {
    const probe::TraversalState state = probe::stateAfter(log, steps);
    if (steps > 0) {
        const probe::TraversalStep& step = log.steps[steps - 1];
        const std::string distance = std::isnan(step.t) ? "" : fmt::format(" at t {:.6g}", step.t);
        text(probe::describe(log, step) + distance);
    } else {
        dimText("before the first step");
    }
    valueRow("Interval", fmt::format("{:.4g} < t <= {:.6g}", log.ray.tMin, state.bound));
    labelledRow("Stack");
    if (state.stack.empty()) return dimText("empty");
    std::string entries;
    constexpr std::size_t kNamed = 4;
    for (std::size_t i = 0; i < std::min(kNamed, state.stack.size()); ++i) {
        const probe::TraversalState::StackEntry& pushed = state.stack[state.stack.size() - 1 - i];
        entries += fmt::format("{}{} at {:.4g}", i > 0 ? "\n" : "", log.boxes[pushed.box].node, pushed.t);
    }
    if (state.stack.size() > kNamed) entries += fmt::format("\nand {} more", state.stack.size() - kNamed);
    text(entries);
}

void drawLog(DebugRays& rays, const probe::TraversalLog& log) {
    ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
    wrappedText(probe::summary(log));
    ImGui::PopStyleColor();
    ui::checkbox("Step by step", &rays.traversal.stepping);
    if (!rays.traversal.stepping) return;
    const int steps = static_cast<int>(log.steps.size());
    rays.traversal.step = std::clamp(rays.traversal.step, 0, steps);
    labelledRow("Step", false, "Left and Right arrow keys take one step, with Shift ten.");
    ui::sliderInt("##step", &rays.traversal.step, 0, steps, fmt::format("%d of {}", steps).c_str(),
                  ImGuiSliderFlags_AlwaysClamp);
    drawStep(log, static_cast<std::size_t>(rays.traversal.step));
}

/// Steps of the two trees do not correspond, so a change restarts the traversal.
void drawLayoutChoice(TraversalOverlayOptions& traversal) {
    labelledRow("Tree", false,
                "The binary tree, as in the panel BVH, or the wide tree with eight children per node that "
                "production rays traverse.");
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
    ui::checkbox("Draw", &rays.traversal.shown);
    tooltip("BVH traversal of the selected ray, or of the first camera ray if none is selected (T).");
    ImGui::SameLine();
    ui::checkbox("Culled", &rays.traversal.culled);
    tooltip("Boxes that the ray hits, but only behind the closest hit so far.");
    ImGui::SameLine();
    ui::checkbox("Missed", &rays.traversal.missed);
    tooltip("Boxes that were tested and missed.");
    if (!rays.traversal.shown) return;
    drawLayoutChoice(rays.traversal);
    if (rays.traversals().empty())
        return wrappedText(rays.traversal.layout == BvhLayout::Wide
                               ? "There is no wide tree: see the setting bvh_layout."
                               : "There is no BVH.");
    for (const probe::TraversalLog& log : rays.traversals()) {
        ImGui::PushID(static_cast<int>(log.motionGroup));
        if (rays.traversals().size() > 1) dimText(fmt::format("motion group {}", log.motionGroup));
        drawLog(rays, log);
        ImGui::PopID();
    }
}

}  // namespace rayscope::viewer
