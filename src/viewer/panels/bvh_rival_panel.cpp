#include <fmt/format.h>

#include "viewer/panels/bvh_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

using Inspected = BvhInspector::Inspected;

constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;
constexpr std::string_view kBuilders[] = {"median", "SAH", "binned SAH", "high quality"};

void drawRecipe(BvhInspector& bvh, const Settings& settings) {
    BvhInspector::Recipe recipe = bvh.rivalRecipe(settings);
    labelledRow("Its builder");
    if (ImGui::BeginCombo("##builder", nameOf(recipe.builder).data())) {
        for (int i = 0; i < static_cast<int>(std::size(kBuilders)); ++i)
            if (ImGui::Selectable(kBuilders[i].data(), static_cast<int>(recipe.builder) == i))
                recipe.builder = static_cast<BvhBuilder>(i);
        ImGui::EndCombo();
    }
    labelledRow("Its bins", false, "Candidate planes per axis of the builders with bins.");
    ImGui::BeginDisabled(!usesBins(recipe.builder));
    ImGui::SliderInt("##bins", &recipe.bins, 2, 4096, "%d", kClamp);
    ImGui::EndDisabled();
    labelledRow("Its leaf size", false, "Most primitives in a leaf.");
    ImGui::SliderInt("##leaf", &recipe.leafSize, 1, 64, "%d", kClamp);
    if (recipe != bvh.rivalRecipe(settings)) bvh.wantedRival = recipe;
}

void row(std::string_view name, std::string_view own, std::string_view other) {
    ImGui::TableNextRow();
    for (const std::string_view words : {name, own, other}) {
        ImGui::TableNextColumn();
        text(words);
    }
}

void drawTable(const BvhInspector& bvh, const Inspected& seen, const Inspected& rival) {
    if (!ImGui::BeginTable("savings", 3, ImGuiTableFlags_SizingStretchProp)) return;
    const auto pair = [](const char* name, const char* format, double own, double other) {
        row(name, fmt::format(fmt::runtime(format), own), fmt::format(fmt::runtime(format), other));
    };
    const probe::LevelComparison c =
        probe::compareAtLevel(seen.tree(), seen.index, rival.tree(), rival.index, bvh.shown.level);
    const bvh::TreeStatistics &a = seen.statistics, &b = rival.statistics;
    row("", "this build", "the other");
    row("", nameOf(seen.builder), nameOf(rival.builder));
    pair("SAH cost", "{:.3f}", c.sahCost[0], c.sahCost[1]);
    row("nodes", fmt::format("{}", a.nodes), fmt::format("{}", b.nodes));
    row("levels", fmt::format("{}", a.levels), fmt::format("{}", b.levels));
    row("boxes on the level", fmt::format("{}", c.boxes[0]), fmt::format("{}", c.boxes[1]));
    pair("of them met by a line", "{:.3f}", c.met[0], c.met[1]);
    if (const BvhInspector::Costs* costs = bvh.costs()) {
        pair("boxes entered per ray", "{:.2f}", costs->own.nodes, costs->rival.nodes);
        pair("tests per ray", "{:.2f}", costs->own.tests, costs->rival.tests);
    }
    ImGui::EndTable();
    if (c.met[1] > 0.0)
        text(fmt::format("saved on this level: {:.1f} %, in all: {:.1f} %",
                         100.0 * (1.0 - c.met[0] / c.met[1]), 100.0 * (1.0 - c.sahCost[0] / c.sahCost[1])));
    if (const BvhInspector::Costs* costs = bvh.costs())
        dimText(fmt::format("counted for {} rays of this view", costs->rays));
}

}  // namespace

std::string_view nameOf(BvhBuilder builder) { return kBuilders[static_cast<int>(builder)]; }

void drawRival(Workspace& workspace, const Inspected& seen) {
    BvhInspector& bvh = workspace.bvh;
    drawRecipe(bvh, workspace.edit.settings);
    if (const Inspected* rival = bvh.rival())
        drawTable(bvh, seen, *rival);
    else
        dimText("building ...");
}

}  // namespace rayscope::viewer
