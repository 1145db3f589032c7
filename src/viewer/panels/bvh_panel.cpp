#include <fmt/format.h>

#include <algorithm>

#include "bvh/layout/statistics.h"
#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

using InspectedTree = BvhInspector::InspectedTree;

constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;

std::string vectorText(glm::vec3 v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); }

/// A slider between two buttons that take one step each. Returns the step.
int steppedSlider(const char* label, int& value, int highest, std::string_view help) {
    labelledRow(label, false, help);
    ImGui::PushID(label);
    const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2.0f * (button + gap));
    ImGui::SliderInt("##value", &value, 0, std::max(0, highest), "%d", kClamp);
    tooltip(help);
    int step = 0;
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("<", {button, 0.0f})) step = -1;
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button(">", {button, 0.0f})) step = 1;
    ImGui::PopID();
    return step;
}

void drawLevels(BvhInspector& bvh, const InspectedTree& seen) {
    BvhOverlayOptions& shown = bvh.shown;
    ImGui::Checkbox("Boxes of a level (B)", &shown.levels);
    ImGui::SameLine();
    ImGui::Checkbox("Leaves above", &shown.leavesAbove);
    tooltip("Also the leaves that end above the level: together the boxes then hold everything.");
    const int step =
        steppedSlider("Level", shown.level, seen.tree().levels - 1, "Page down and page up step.");
    if (step != 0) bvh.stepLevel(step);
}

void drawLeaf(BvhInspector& bvh, const InspectedTree& seen) {
    ImGui::Checkbox("One leaf and its primitives", &bvh.shown.leaf);
    const int leaves = static_cast<int>(seen.index.leaves.size());
    const int step = steppedSlider("Leaf", bvh.shown.leafNumber, leaves - 1,
                                   "In preorder; the keys . and , step, G goes to the "
                                   "one under the cursor.");
    if (step != 0) bvh.stepLeaf(step);
    if (!bvh.shown.leaf || bvh.shown.leafNumber >= leaves) return;
    const std::uint32_t node = seen.index.leaves[static_cast<std::size_t>(bvh.shown.leafNumber)];
    constexpr std::size_t kNamed = 12;
    const auto primitives = probe::primitivesOfLeaf(seen.tree(), node);
    std::string words = fmt::format("node {}, level {}: primitives", node, seen.index.level[node]);
    for (const std::uint32_t primitive : primitives.first(std::min(primitives.size(), kNamed)))
        words += fmt::format(" {}", primitive);
    if (primitives.size() > kNamed) words += fmt::format(" and {} more", primitives.size() - kNamed);
    ImGui::PushStyleColor(ImGuiCol_Text, kDimText);
    wrappedText(words);
    ImGui::PopStyleColor();
}

void drawBuild(Workspace& workspace, const InspectedTree& seen) {
    Settings& settings = workspace.edit.settings;
    labelledRow("Max level", settings.bvhMaxLevel != Settings{}.bvhMaxLevel,
                "The deepest level that is built (setting bvh_max_level); moving it builds anew.");
    ImGui::SliderInt("##max", &settings.bvhMaxLevel, 0, bvh::kMaxTreeLevel, "%d", kClamp);
    const bvh::TreeStatistics& s = seen.statistics;
    valueRow("Built", fmt::format("{}, {} levels", nameOf(seen.builder), s.levels));
    valueRow("Nodes", fmt::format("{}, {} are leaves", s.nodes, s.leaves));
    valueRow("SAH cost", fmt::format("{:.3f}", s.sahCost));
    valueRow("Memory", fmt::format("{:.1f} KiB", static_cast<double>(s.bytes) / 1024.0));
}

bool isAncestor(const probe::TreeIndex& index, std::uint32_t node, std::uint32_t below) {
    while (below != bvh::kNoNode && below != node) below = index.parent[below];
    return below == node;
}

/// A node and, where it is unfolded, everything below it.
void drawNode(BvhInspector& bvh, const InspectedTree& seen, std::uint32_t number, bool reveal) {
    const bvh::BinaryNode& node = seen.tree().nodes[number];
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (node.isLeaf()) flags |= ImGuiTreeNodeFlags_Leaf;
    const bool selected = number == bvh.shown.node;
    if (selected) flags |= ImGuiTreeNodeFlags_Selected;
    if (reveal && !selected && isAncestor(seen.index, number, bvh.shown.node)) ImGui::SetNextItemOpen(true);
    const std::string label = node.isLeaf()
                                  ? fmt::format("leaf {}: {} primitives", number, node.count)
                                  : fmt::format("node {}: {} below, cost {:.2f}", number,
                                                seen.index.primitives[number], seen.index.cost[number]);
    const bool open = ImGui::TreeNodeEx(
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(number) + 1), flags, "%s", label.c_str());
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) bvh.select(selected ? bvh::kNoNode : number);
    if (reveal && selected) ImGui::SetScrollHereY();
    if (!open) return;
    if (!node.isLeaf())
        for (const std::uint32_t child : {node.first, node.first + 1}) drawNode(bvh, seen, child, reveal);
    ImGui::TreePop();
}

void drawSelected(const InspectedTree& seen, std::uint32_t number) {
    if (number >= seen.tree().nodes.size()) return dimText("Click a node to see it in the picture.");
    const bvh::BinaryNode& node = seen.tree().nodes[number];
    const double rootArea = bvh::halfArea(seen.tree().nodes[0]);
    valueRow("Node", fmt::format("{}, level {}", number, seen.index.level[number]));
    valueRow("Lower", vectorText(node.lower));
    valueRow("Upper", vectorText(node.upper));
    valueRow("Primitives", fmt::format("{}", seen.index.primitives[number]));
    valueRow("SAH cost", fmt::format("{:.4g} once entered", seen.index.cost[number]));
    if (rootArea > 0.0)
        valueRow("Entered", fmt::format("by {:.3g} % of all lines", 100.0 * bvh::halfArea(node) / rootArea));
    if (!node.isLeaf())
        valueRow("Overlap",
                 fmt::format("both children: {:.3g} %", 100.0 * probe::childOverlap(seen.tree(), number)));
}

void drawTree(BvhInspector& bvh, const InspectedTree& seen) {
    const bool reveal = bvh.takeSelectionChange() && bvh.shown.node != bvh::kNoNode;
    if (ImGui::BeginChild("nodes", {0.0f, scaled(150.0f)}, true, ImGuiWindowFlags_HorizontalScrollbar))
        drawNode(bvh, seen, 0, reveal);
    ImGui::EndChild();
    drawSelected(seen, bvh.shown.node);
}

void drawHistogram(const char* title, const char* unit, const std::vector<std::size_t>& counts) {
    std::vector<float> values(counts.begin(), counts.end());
    dimText(fmt::format("{}, 0 to {}", title, counts.empty() ? 0 : counts.size() - 1));
    ImGui::PushID(title);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PlotHistogram("##counts", values.data(), static_cast<int>(values.size()), 0, nullptr, 0.0f,
                         FLT_MAX, {width, scaled(54.0f)});
    if (ImGui::IsItemHovered() && !counts.empty()) {
        const float share = (ImGui::GetIO().MousePos.x - at.x) / width;
        const auto bar =
            std::min(static_cast<std::size_t>(std::max(share, 0.0f) * static_cast<float>(counts.size())),
                     counts.size() - 1);
        ImGui::SetTooltip("%s", fmt::format("{} leaves {} {}", counts[bar], unit, bar).c_str());
    }
    ImGui::PopID();
}

}  // namespace

void drawBvhPanel(Workspace& workspace) {
    workspace.bvhPanelOpen = true;
    BvhInspector& bvh = workspace.bvh;
    const InspectedTree* seen = bvh.inspected();
    if (seen == nullptr) {
        wrappedText(workspace.edit.settings.bvh ? "There is nothing to search, or it is being prepared."
                                                : "The BVH is off: every ray tests every primitive.");
        return;
    }
    const auto world = workspace.render.session().world();
    if (world && world->motionGroups.size() > 1) {
        int motionGroup = static_cast<int>(bvh.motionGroup);
        const int step = steppedSlider("Body", motionGroup, static_cast<int>(world->motionGroups.size()) - 1,
                                       "Things that move alike share a hierarchy; body 0 is at rest.");
        const int last = static_cast<int>(world->motionGroups.size()) - 1;
        bvh.motionGroup = static_cast<std::size_t>(std::clamp(motionGroup + step, 0, last));
    }
    const auto section = [](const char* name) {
        return ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen);
    };
    if (section("Boxes")) {
        drawLevels(bvh, *seen);
        drawLeaf(bvh, *seen);
        ImGui::Checkbox("Savings against another build", &bvh.shown.showReference);
        tooltip(
            "Below the boxes of the level, in red, those of the build that it is compared with: where red "
            "shows, space is saved.");
    }
    if (section("Build")) drawBuild(workspace, *seen);
    if (bvh.shown.showReference && section("Against another build")) drawReferenceTree(workspace, *seen);
    if (section("Nodes")) drawTree(bvh, *seen);
    if (section("Splits of the node")) drawSplitCurve(bvh, workspace.edit.settings.bvhBins);
    if (section("Leaves")) {
        drawHistogram("Leaves by level", "on level", seen->statistics.leavesAtLevel);
        drawHistogram("Leaves by number of primitives",
                      "with this many primitives:", seen->statistics.leavesOfSize);
    }
}

}  // namespace rayscope::viewer
