// The tabs of the side panel and the choice of the view above them.
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

void drawViewChoice(ViewState& view) {
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (toggleButton("Rasterised", !view.traced, half)) view.traced = false;
    tooltip("OpenGL preview without shadows and reflections (Tab).");
    ImGui::SameLine();
    if (toggleButton("Ray-traced", view.traced, half)) view.traced = true;
    tooltip("Traced on the CPU, refined until all samples are taken (Tab).");
    ImGui::Spacing();
}

void drawSceneTab(Workspace& workspace) {
    if (ui::section("Contents")) drawScenePanel(workspace);
    if (ui::section("Camera")) drawCameraPanel(workspace);
    if (ui::section("Lights")) drawLightsPanel(workspace);
    if (ui::section("Numerical robustness", 0)) drawLabPanel(workspace);
}

struct Tab {
    const char* name;
    void (*draw)(Workspace&);
};
constexpr Tab kTabs[] = {{"Scene", drawSceneTab}, {"Settings", drawSettingsPanel},
                         {"Rays", drawRaysPanel}, {"BVH", drawBvhPanel},
                         {"Map", drawHeatPanel},  {"A/B", drawComparisonPanel}};

}  // namespace

void drawSidePanelContents(Workspace& workspace) {
    drawViewChoice(workspace.view);
    if (!ImGui::BeginTabBar("##tabs")) return;
    for (const Tab& tab : kTabs) ui::tab(tab.name, [&] { tab.draw(workspace); });
    ImGui::EndTabBar();
}

}  // namespace rayscope::viewer
