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
    if (ImGui::CollapsingHeader("Contents", ImGuiTreeNodeFlags_DefaultOpen)) drawScenePanel(workspace);
    if (ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen)) drawCameraPanel(workspace);
    if (ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen)) drawLightsPanel(workspace);
    if (ImGui::CollapsingHeader("Numerical robustness")) drawLabPanel(workspace);
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
    for (const Tab& tab : kTabs) {
        if (!ImGui::BeginTabItem(tab.name)) continue;
        ImGui::BeginChild(tab.name, {0.0f, 0.0f}, false, ImGuiWindowFlags_NoNavInputs);
        tab.draw(workspace);
        ImGui::EndChild();
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

}  // namespace rayscope::viewer
