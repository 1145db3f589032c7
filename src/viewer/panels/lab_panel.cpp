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
    if (ui::button("Test numerical robustness", {-1.0f, 0.0f}))
        lab.start(workspace.edit.scene, workspace.edit.settings, 0);
    tooltip(
        "Scales the triangles of the scene by 2^-40 to 2^40, offsets them by up to 10^7 times their size, "
        "and compares the hits of rays with exact arithmetic.");
    ui::checkbox("Coarse steps", &lab.quick);
}

/// Passed and failed test points of a method as a map: scales downwards, offsets to the right.
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
    tooltip("Rows: scales from 2^-40 to 2^40. Columns: offsets from 0 to 10^7 sizes. Red: failed.");
}

void drawMethod(const LabResult& result, LabMethod method) {
    const LabRange& range = result.range(method);
    const LabCounts sum = result.total(method);
    text(infoOf(method).label);
    drawMap(result, method);
    dimText(fmt::format("{} of {} test points fail", range.failingTestPoints, result.testPoints.size()));
    dimText(fmt::format("{} leaks, {} double hits,\n{} false hits, {} missed surfaces", sum.leaks,
                        sum.doubleHits, sum.falseHits, sum.missedSurfaces));
    if (range.soundUntransformed)
        dimText(fmt::format("passes for scales 2^{} to 2^{}\nand offsets up to {:g} sizes", range.lowestScale,
                            range.highestScale, range.largestOffset));
    else
        dimText("fails for the unchanged scene");
    ImGui::Spacing();
}

void drawOverlayChoice(LabJob& lab) {
    ui::checkbox("Draw failed rays", &lab.overlay);
    labelledRow("Method", false, "Rays are transformed back from the scale and offset at which they failed.");
    ui::combo("##method", infoOf(lab.shownMethod).label, [&] {
        for (const LabMethod method : kLabMethods)
            if (ui::selectable(infoOf(method).label, method == lab.shownMethod)) lab.shownMethod = method;
    });
}

}  // namespace

void drawLabPanel(Workspace& workspace) {
    LabJob& lab = workspace.lab;
    drawStart(workspace, lab);
    if (!lab.errorMessage().empty()) wrappedText(lab.errorMessage());
    const LabResult* result = lab.result();
    if (!result) return;
    if (lab.scene() != workspace.edit.scene.get()) dimText("The scene has changed since the test.");
    drawOverlayChoice(lab);
    for (const LabMethod method : kLabMethods) drawMethod(*result, method);
    dimText(fmt::format("No triangle degenerates\nat offsets up to {:g} sizes.", result->meshOffset));
    for (const std::string& remark : result->remarks) wrappedText(remark);
}

}  // namespace rayscope::viewer
