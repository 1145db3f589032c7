#include <fmt/format.h>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawStart(Workspace& workspace, LabJob& lab) {
    if (lab.busy()) {
        if (stoppableProgress(lab.fraction())) lab.stop();
        return;
    }
    if (ImGui::Button("Try this scene at the extremes", {-1.0f, 0.0f}))
        lab.start(workspace.edit.scene, workspace.edit.settings, 0);
    tooltip(
        "Scales the triangles of the scene from 2^-40 to 2^40, moves them up to 10^7 sizes away, and "
        "compares what rays hit there with exact arithmetic.");
    ImGui::Checkbox("Coarse steps", &lab.quick);
}

/// Failing testPoints of a method as a map: scales down, offsets to the right.
void drawMap(const LabResult& result, LabMethod method) {
    if (result.testPoints.empty()) return;
    const float side = scaled(11.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    int row = -1, column = 0, columns = 0, scale = 1 << 20;
    for (const LabTestPoint& testPoint : result.testPoints) {
        if (testPoint.transform.scale != scale) {
            scale = testPoint.transform.scale;
            column = 0;
            ++row;
        }
        const ImU32 color =
            testPoint.of(method).passed() ? IM_COL32(60, 150, 90, 255) : IM_COL32(215, 65, 45, 255);
        const ImVec2 corner(at.x + side * static_cast<float>(column++),
                            at.y + side * static_cast<float>(row));
        draw.AddRectFilled(corner, {corner.x + side - 1.0f, corner.y + side - 1.0f}, color);
        columns = std::max(columns, column);
    }
    ImGui::Dummy({side * static_cast<float>(columns), side * static_cast<float>(row + 1)});
    tooltip("Rows are scales from 2^-40 to 2^40, columns offsets from 0 to 10^7 sizes; red is a mistake.");
}

void drawMethod(const LabResult& result, LabMethod method) {
    const LabRange& range = result.range(method);
    const LabCounts sum = result.total(method);
    text(infoOf(method).label);
    drawMap(result, method);
    dimText(fmt::format("{} of {} cells fail", range.failingTestPoints, result.testPoints.size()));
    dimText(fmt::format("{} leaks, {} double hits,\n{} false hits, {} lost surfaces", sum.leaks,
                        sum.doubleHits, sum.falseHits, sum.missedSurfaces));
    if (range.soundUntransformed)
        dimText(fmt::format("sound from 2^{} to 2^{} times its size,\nand to {:g} sizes from the origin",
                            range.lowestScale, range.highestScale, range.largestOffset));
    else
        dimText("fails with the scene as it is");
    ImGui::Spacing();
}

void drawOverlayChoice(LabJob& lab) {
    ImGui::Checkbox("Draw the rays that went wrong", &lab.overlay);
    labelledRow("Of", false, "Rays are brought back from the scale and place where they went wrong.");
    if (ImGui::BeginCombo("##method", infoOf(lab.shownMethod).label)) {
        for (const LabMethod method : kLabMethods)
            if (ImGui::Selectable(infoOf(method).label, method == lab.shownMethod)) lab.shownMethod = method;
        ImGui::EndCombo();
    }
}

}  // namespace

void drawLabPanel(Workspace& workspace) {
    LabJob& lab = workspace.lab;
    drawStart(workspace, lab);
    if (!lab.errorMessage().empty()) wrappedText(lab.errorMessage());
    const LabResult* result = lab.result();
    if (!result) return;
    if (lab.scene() != workspace.edit.scene.get()) dimText("The scene has changed since.");
    drawOverlayChoice(lab);
    for (const LabMethod method : kLabMethods) drawMethod(*result, method);
    dimText(
        fmt::format("The mesh keeps its triangles\nup to {:g} sizes from the origin.", result->meshOffset));
    for (const std::string& remark : result->remarks) wrappedText(remark);
}

}  // namespace rayscope::viewer
