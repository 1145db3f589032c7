#include <fmt/format.h>

#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

using InspectedTree = BvhInspector::InspectedTree;

constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
constexpr std::string_view kBuilders[] = {"median", "SAH", "binned SAH", "high quality"};

void drawBuilderSettings(BvhInspector& bvh, const Settings& settings) {
    BvhInspector::BuilderSettings builderSettings = bvh.referenceBuild(settings);
    labelledRow("Its builder");
    if (ImGui::BeginCombo("##builder", nameOf(builderSettings.builder).data())) {
        for (int i = 0; i < static_cast<int>(std::size(kBuilders)); ++i)
            if (ImGui::Selectable(kBuilders[i].data(), static_cast<int>(builderSettings.builder) == i))
                builderSettings.builder = static_cast<BvhBuilder>(i);
        ImGui::EndCombo();
    }
    labelledRow("Its bins", false, "Candidate planes per axis of the builders with bins.");
    ImGui::BeginDisabled(!usesBins(builderSettings.builder));
    ImGui::SliderInt("##bins", &builderSettings.bins, 2, 4096, "%d", kClamp);
    ImGui::EndDisabled();
    labelledRow("Its leaf size", false, "Most primitives in a leaf.");
    ImGui::SliderInt("##leaf", &builderSettings.leafSize, 1, 64, "%d", kClamp);
    if (builderSettings != bvh.referenceBuild(settings)) bvh.compareWith = builderSettings;
}

void row(std::string_view name, std::string_view own, std::string_view other) {
    ImGui::TableNextRow();
    for (const std::string_view words : {name, own, other}) {
        ImGui::TableNextColumn();
        text(words);
    }
}

void drawTable(const BvhInspector& bvh, const InspectedTree& seen, const InspectedTree& referenceTree) {
    if (!ImGui::BeginTable("savings", 3, ImGuiTableFlags_SizingStretchProp)) return;
    const auto pair = [](const char* name, const char* format, double own, double other) {
        row(name, fmt::format(fmt::runtime(format), own), fmt::format(fmt::runtime(format), other));
    };
    const probe::LevelComparison c = probe::compareAtLevel(seen.tree(), seen.index, referenceTree.tree(),
                                                           referenceTree.index, bvh.shown.level);
    const bvh::TreeStatistics &a = seen.statistics, &b = referenceTree.statistics;
    row("", "this build", "the other");
    row("", nameOf(seen.builder), nameOf(referenceTree.builder));
    pair("SAH cost", "{:.3f}", c.sahCost[0], c.sahCost[1]);
    row("nodes", fmt::format("{}", a.nodes), fmt::format("{}", b.nodes));
    row("levels", fmt::format("{}", a.levels), fmt::format("{}", b.levels));
    row("boxes on the level", fmt::format("{}", c.boxes[0]), fmt::format("{}", c.boxes[1]));
    pair("of them met by a line", "{:.3f}", c.expectedHits[0], c.expectedHits[1]);
    if (const BvhInspector::Costs* costs = bvh.costs()) {
        pair("boxes entered per ray", "{:.2f}", costs->own.nodes, costs->referenceTree.nodes);
        pair("tests per ray", "{:.2f}", costs->own.tests, costs->referenceTree.tests);
    }
    ImGui::EndTable();
    if (c.expectedHits[1] > 0.0)
        text(fmt::format("saved on this level: {:.1f} %, in all: {:.1f} %",
                         100.0 * (1.0 - c.expectedHits[0] / c.expectedHits[1]),
                         100.0 * (1.0 - c.sahCost[0] / c.sahCost[1])));
    if (const BvhInspector::Costs* costs = bvh.costs())
        dimText(fmt::format("counted for {} rays of this view", costs->rays));
}

}  // namespace

std::string_view nameOf(BvhBuilder builder) { return kBuilders[static_cast<int>(builder)]; }

void drawReferenceTree(Workspace& workspace, const InspectedTree& seen) {
    BvhInspector& bvh = workspace.bvh;
    drawBuilderSettings(bvh, workspace.edit.settings);
    if (const InspectedTree* referenceTree = bvh.referenceTree())
        drawTable(bvh, seen, *referenceTree);
    else
        dimText("building ...");
}

}  // namespace rayscope::viewer
