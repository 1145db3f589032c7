#include <fmt/format.h>

#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

using InspectedTree = BvhInspector::InspectedTree;

constexpr std::string_view kBuilders[] = {"median", "SAH", "binned SAH", "reinsertion"};

void drawBuilderSettings(BvhInspector& bvh, const Settings& settings) {
    BvhInspector::BuilderSettings builderSettings = bvh.referenceBuild(settings);
    labelledRow("Builder");
    ui::combo("##builder", nameOf(builderSettings.builder).data(), [&] {
        for (int i = 0; i < static_cast<int>(std::size(kBuilders)); ++i)
            if (ui::selectable(kBuilders[i].data(), static_cast<int>(builderSettings.builder) == i))
                builderSettings.builder = static_cast<BvhBuilder>(i);
    });
    labelledRow("Bins", false, "Bins per axis of the binned builders.");
    ImGui::BeginDisabled(!usesBins(builderSettings.builder));
    ui::sliderInt("##bins", &builderSettings.bins, 2, 4096, "%d", kClamp | ImGuiSliderFlags_Logarithmic);
    ImGui::EndDisabled();
    labelledRow("Leaf size", false, "Maximum number of primitives in a leaf.");
    ui::sliderInt("##leaf", &builderSettings.leafSize, 1, 64, "%d", kClamp | ImGuiSliderFlags_Logarithmic);
    if (builderSettings != bvh.referenceBuild(settings)) bvh.compareWith = builderSettings;
}

void row(std::string_view name, std::string_view own, std::string_view other) {
    ImGui::TableNextRow();
    for (const std::string_view cell : {name, own, other}) {
        ImGui::TableNextColumn();
        text(cell);
    }
}

void drawTable(const BvhInspector& bvh, const InspectedTree& inspected, const InspectedTree& referenceTree) {
    if (!ImGui::BeginTable("comparison", 3, ImGuiTableFlags_SizingStretchProp)) return;
    const auto pair = [](const char* name, const char* format, double own, double other) {
        row(name, fmt::format(fmt::runtime(format), own), fmt::format(fmt::runtime(format), other));
    };
    const probe::LevelComparison c = probe::compareAtLevel(
        inspected.tree(), inspected.index, referenceTree.tree(), referenceTree.index, bvh.shown.level);
    const bvh::TreeStatistics &a = inspected.statistics, &b = referenceTree.statistics;
    row("", "this BVH", "other");
    row("", nameOf(inspected.builder), nameOf(referenceTree.builder));
    pair("build time", "{:.3f} s", inspected.buildSeconds, referenceTree.buildSeconds);
    pair("SAH cost", "{:.3f}", c.sahCost[0], c.sahCost[1]);
    row("nodes", fmt::format("{}", a.nodes), fmt::format("{}", b.nodes));
    row("levels", fmt::format("{}", a.levels), fmt::format("{}", b.levels));
    row("boxes on level", fmt::format("{}", c.boxes[0]), fmt::format("{}", c.boxes[1]));
    pair("hit by a line", "{:.3f}", c.expectedHits[0], c.expectedHits[1]);
    if (const BvhInspector::Costs* costs = bvh.costs()) {
        pair("visits per ray", "{:.2f}", costs->own.nodes, costs->referenceTree.nodes);
        pair("tests per ray", "{:.2f}", costs->own.tests, costs->referenceTree.tests);
    }
    ImGui::EndTable();
    if (c.expectedHits[1] > 0.0)
        text(fmt::format("reduction: level {:.1f} %, SAH cost {:.1f} %",
                         100.0 * (1.0 - c.expectedHits[0] / c.expectedHits[1]),
                         100.0 * (1.0 - c.sahCost[0] / c.sahCost[1])));
    if (const BvhInspector::Costs* costs = bvh.costs())
        dimText(fmt::format("counted over {} rays of this view", costs->rays));
}

}  // namespace

std::string_view nameOf(BvhBuilder builder) { return kBuilders[static_cast<int>(builder)]; }

void drawReferenceTree(Workspace& workspace, const InspectedTree& inspected) {
    BvhInspector& bvh = workspace.bvh;
    drawBuilderSettings(bvh, workspace.edit.settings);
    if (const InspectedTree* referenceTree = bvh.referenceTree())
        drawTable(bvh, inspected, *referenceTree);
    else
        dimText("building ...");
}

}  // namespace rayscope::viewer
