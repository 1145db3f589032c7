#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/byte_size.h"
#include "bvh/layout/statistics.h"
#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/plot.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

using InspectedTree = BvhInspector::InspectedTree;

/// A slider with a button for a step back and one for a step forward. Returns the step: -1, 0 or 1.
int steppedSlider(const char* label, int& value, int highest, std::string_view help) {
    labelledRow(label, false, help);
    ImGui::PushID(label);
    const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2.0f * (button + gap));
    ui::sliderInt("##value", &value, 0, std::max(0, highest), "%d", kClamp);
    tooltip(help);
    const ui::Scope scope(label);
    int step = 0;
    ImGui::SameLine(0.0f, gap);
    if (ui::button("<", {button, 0.0f})) step = -1;
    ImGui::SameLine(0.0f, gap);
    if (ui::button(">", {button, 0.0f})) step = 1;
    ImGui::PopID();
    return step;
}

void drawLevels(BvhInspector& bvh, const InspectedTree& inspected) {
    BvhOverlayOptions& shown = bvh.shown;
    ui::checkbox("Boxes of a level (B)", &shown.levels);
    ImGui::SameLine();
    ui::checkbox("Leaves above", &shown.leavesAbove);
    tooltip("Also draw the leaves above this level, so that the boxes together contain all primitives.");
    const int step =
        steppedSlider("Level", shown.level, inspected.tree().levels - 1, "Also with Page down and Page up.");
    if (step != 0) bvh.stepLevel(step);
}

void drawLeaf(BvhInspector& bvh, const InspectedTree& inspected) {
    ui::checkbox("Highlight one leaf", &bvh.shown.leaf);
    tooltip("The box of the leaf and the outlines of its primitives.");
    const int leaves = static_cast<int>(inspected.index.leaves.size());
    const int step =
        steppedSlider("Leaf", bvh.shown.leafNumber, leaves - 1,
                      "In preorder. The keys . and , step; G selects the leaf under the cursor.");
    if (step != 0) bvh.stepLeaf(step);
    // The line is there in any case, so that the controls below do not move.
    if (!bvh.shown.leaf || bvh.shown.leafNumber >= leaves) return dimText("no leaf is highlighted");
    const std::uint32_t node = inspected.index.leaves[static_cast<std::size_t>(bvh.shown.leafNumber)];
    constexpr std::size_t kNamed = 12;
    const auto primitives = probe::primitivesOfLeaf(inspected.tree(), node);
    std::string content = fmt::format("node {}, level {}: primitives", node, inspected.index.level[node]);
    for (const std::uint32_t primitive : primitives.first(std::min(primitives.size(), kNamed)))
        content += fmt::format(" {}", primitive);
    if (primitives.size() > kNamed) content += fmt::format(" and {} more", primitives.size() - kNamed);
    ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
    fittedText(content);
    ImGui::PopStyleColor();
}

void drawBuild(Workspace& workspace, const InspectedTree& inspected) {
    Settings& settings = workspace.edit.settings;
    labelledRow("Max level", settings.bvhMaxLevel != Settings{}.bvhMaxLevel,
                "Deepest level of the tree (setting bvh_max_level). A change rebuilds the tree.");
    ui::sliderInt("##max", &settings.bvhMaxLevel, 0, bvh::kMaxTreeLevel, "%d", kClamp);
    const bvh::TreeStatistics& s = inspected.statistics;
    valueRow("Builder", fmt::format("{}, {} levels", nameOf(inspected.builder), s.levels));
    valueRow("Nodes", fmt::format("{} ({} leaves)", s.nodes, s.leaves));
    valueRow("Build time", fmt::format("{:.3f} s", inspected.buildSeconds),
             "Of the BVHs of all motion groups, wide trees included; it stays until they are built again.");
    valueRow("SAH cost", fmt::format("{:.3f}", s.sahCost));
    valueRow("Memory", base::byteSizeText(s.bytes));
}

bool isAncestor(const probe::TreeIndex& index, std::uint32_t node, std::uint32_t below) {
    while (below != bvh::kNoNode && below != node) below = index.parent[below];
    return below == node;
}

/// A node and, if it is open, its subtree.
void drawNode(BvhInspector& bvh, const InspectedTree& inspected, std::uint32_t number, bool reveal) {
    const bvh::BinaryNode& node = inspected.tree().nodes[number];
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (node.isLeaf()) flags |= ImGuiTreeNodeFlags_Leaf;
    const bool selected = number == bvh.shown.node;
    if (selected) flags |= ImGuiTreeNodeFlags_Selected;
    if (reveal && !selected && isAncestor(inspected.index, number, bvh.shown.node))
        ImGui::SetNextItemOpen(true);
    const std::string label =
        node.isLeaf() ? fmt::format("leaf {}: {} primitives", number, node.count)
                      : fmt::format("node {}: {} primitives, cost {:.2f}", number,
                                    inspected.index.primitives[number], inspected.index.cost[number]);
    const bool open = ImGui::TreeNodeEx(
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(number) + 1), flags, "%s", label.c_str());
    ui::note(label.c_str());
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) bvh.select(selected ? bvh::kNoNode : number);
    if (reveal && selected) ImGui::SetScrollHereY();
    if (!open) return;
    if (!node.isLeaf())
        for (const std::uint32_t child : {node.first, node.first + 1})
            drawNode(bvh, inspected, child, reveal);
    ImGui::TreePop();
}

void drawSelected(const InspectedTree& inspected, std::uint32_t number) {
    if (number >= inspected.tree().nodes.size()) return dimText("Click a node to highlight it.");
    const bvh::BinaryNode& node = inspected.tree().nodes[number];
    const double rootArea = bvh::halfArea(inspected.tree().nodes[0]);
    valueRow("Node", fmt::format("{}, level {}", number, inspected.index.level[number]));
    valueRow("Lower", vectorText(node.lower));
    valueRow("Upper", vectorText(node.upper));
    valueRow("Primitives", fmt::format("{}", inspected.index.primitives[number]));
    valueRow("SAH cost", fmt::format("{:.4g}", inspected.index.cost[number]),
             "Expected cost of a ray that visits the node.");
    if (rootArea > 0.0)
        valueRow("Visited", fmt::format("by {:.3g} % of lines", 100.0 * bvh::halfArea(node) / rootArea),
                 "Share of the random lines through the root box that intersect this box.");
    if (!node.isLeaf())
        valueRow("Overlap", fmt::format("{:.3g} %", 100.0 * probe::childOverlap(inspected.tree(), number)),
                 "Surface area of the intersection of both child boxes, relative to the area of this box.");
}

void drawTree(BvhInspector& bvh, const InspectedTree& inspected) {
    const bool reveal = bvh.takeSelectionChange() && bvh.shown.node != bvh::kNoNode;
    if (ImGui::BeginChild("nodes", {0.0f, scaled(150.0f)}, true, ImGuiWindowFlags_HorizontalScrollbar))
        drawNode(bvh, inspected, 0, reveal);
    ImGui::EndChild();
    drawSelected(inspected, bvh.shown.node);
}

void drawHistogram(const char* title, const char* unit, const std::vector<std::size_t>& counts) {
    if (counts.empty()) return;
    const auto most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
    const double last = static_cast<double>(counts.size()) - 0.5;
    const Plot plot(title, scaled(120.0f), {-0.5, last, false, unit},
                    {0.0, std::max(most, 1.0), false, title});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto value = static_cast<double>(i);
        const ImVec2 upper = plot.position(value - 0.45, static_cast<double>(counts[i])),
                     lower = plot.position(value + 0.45, 0.0);
        ImGui::GetWindowDrawList()->AddRectFilled(upper, lower, ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    }
    if (!plot.hovered()) return;
    const auto bar = static_cast<std::size_t>(std::clamp(std::round(plot.xAtCursor()), 0.0, last - 0.5));
    showTooltip(fmt::format("{} {}: {} leaves", unit, bar, counts[bar]));
}

}  // namespace

void drawBvhPanel(Workspace& workspace) {
    workspace.bvhPanelOpen = true;
    BvhInspector& bvh = workspace.bvh;
    const InspectedTree* inspected = bvh.inspected();
    if (inspected == nullptr) {
        wrappedText(workspace.edit.settings.bvh ? "No BVH: the scene is empty or still being prepared."
                                                : "The BVH is off: every ray tests every primitive.");
        return;
    }
    const std::shared_ptr<const trace::World> world = workspace.worldOfScene();
    if (world && world->motionGroups.size() > 1) {
        int motionGroup = static_cast<int>(bvh.motionGroup);
        const int step =
            steppedSlider("Motion group", motionGroup, static_cast<int>(world->motionGroups.size()) - 1,
                          "Primitives with the same motion share a BVH; group 0 is at rest.");
        const int last = static_cast<int>(world->motionGroups.size()) - 1;
        bvh.motionGroup = static_cast<std::size_t>(std::clamp(motionGroup + step, 0, last));
    }
    if (ui::section("Boxes")) {
        drawLevels(bvh, *inspected);
        drawLeaf(bvh, *inspected);
        ui::checkbox("Compare with another BVH", &bvh.shown.showReference);
        tooltip(
            "Draws the boxes of the reference tree in red, below those of this tree. Red areas are covered "
            "by the reference tree only.");
    }
    if (ui::section("Build")) drawBuild(workspace, *inspected);
    if (bvh.shown.showReference && ui::section("Comparison with another BVH"))
        drawReferenceTree(workspace, *inspected);
    if (ui::section("Nodes")) drawTree(bvh, *inspected);
    if (ui::section("Split costs of the node")) drawSplitCurve(bvh, workspace.edit.settings.bvhBins);
    if (ui::section("Leaves")) {
        drawHistogram("Leaves by level", "level", inspected->statistics.leavesAtLevel);
        drawHistogram("Leaves by size", "primitives", inspected->statistics.leavesOfSize);
    }
}

}  // namespace rayscope::viewer
