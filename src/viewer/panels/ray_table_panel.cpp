#include <fmt/format.h>

#include <algorithm>

#include "trace/world.h"
#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/panels/ray_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

int levelOf(const RayTree& tree, int node) {
    int level = 0;
    while ((node = tree.nodes[static_cast<std::size_t>(node)].parent) >= 0) ++level;
    return level;
}

double largest(const RgbSum& c) { return std::max({c.x, c.y, c.z}); }

/// Kind, hit distance and object, and contribution.
struct Row {
    std::string kind, where, adds;
};
Row rowOf(const trace::World& world, const RayTree& tree, RaySelection ray) {
    if (ray.shadow >= 0) {
        const ShadowRay& shadow = tree.shadowRays[static_cast<std::size_t>(ray.shadow)];
        const int level = levelOf(tree, shadow.node) + 1;
        return {std::string(static_cast<std::size_t>(level), ' ') + fmt::format("light {}", shadow.light),
                fmt::format("#{} {}", shadow.sample, nameOf(shadow.visibility)),
                fmt::format("{:.2g}", largest(shadow.contribution))};
    }
    const RayNode& node = tree.nodes[static_cast<std::size_t>(ray.node)];
    std::string where(nameOf(node.end));
    if (node.hit) where = fmt::format("{:.4g} {}", node.primitiveHit.t, objectName(world, node.object));
    return {std::string(static_cast<std::size_t>(levelOf(tree, ray.node)), ' ') +
                fmt::format("{} {}", nameOf(node.kind), node.depth),
            where, fmt::format("{:.2g}", largest(node.contribution))};
}

void drawNode(const trace::World& world, const RayNode& node) {
    valueRow("Origin", vectorText(node.ray.origin));
    valueRow("Direction", vectorText(node.ray.direction));
    if (node.hit) {
        const trace::PrimitiveLocation name = world.locatePrimitive(node.primitiveHit.primitive);
        valueRow("Hit", objectName(world, node.object));
        valueRow(name.range->mesh ? "Triangle" : "Sphere", fmt::format("{}", name.inObject));
        valueRow("t", fmt::format("{:.9g}", node.primitiveHit.t));
        valueRow("u, v", fmt::format("{:.6g}, {:.6g}", node.primitiveHit.u, node.primitiveHit.v));
        valueRow("Normal", vectorText(node.normal));
        valueRow("Opacity", fmt::format("{:.4g}", node.opacity));
    }
    valueRow("Throughput", vectorText(node.throughput));
    valueRow("Contribution", vectorText(node.contribution));
    valueRow("End", std::string(nameOf(node.end)));
}

void drawShadowRay(const ShadowRay& ray) {
    valueRow("From", vectorText(ray.from));
    valueRow("To", vectorText(ray.to));
    valueRow("Light", fmt::format("{}, sample {}", ray.light, ray.sample));
    valueRow("Visibility", std::string(nameOf(ray.visibility)));
    valueRow("Colour", vectorText(RgbSum(ray.color)));
    valueRow("Contribution", vectorText(ray.contribution));
}

void drawActions(Workspace& workspace) {
    const DebugRays& rays = workspace.rays;
    const auto button = [&](const char* label, int perRow, Command command, const char* help) {
        const float gaps = ImGui::GetStyle().ItemSpacing.x * static_cast<float>(perRow - 1);
        static float rowWidth = 0.0f;
        if (ImGui::GetCursorPosX() < scaled(20.0f)) rowWidth = ImGui::GetContentRegionAvail().x;
        if (ui::button(label, {(rowWidth - gaps) / static_cast<float>(perRow), 0.0f}))
            workspace.commands.push_back(command);
        tooltip(help);
    };
    ImGui::BeginDisabled(rays.selection().empty());
    button("Hide (H)", 3, Command::HideRay, "Do not draw the selected ray. Ctrl+Z draws it again.");
    ImGui::SameLine();
    button(rays.filter.isolated ? "All (I)" : "Isolate (I)", 3, Command::IsolateRay,
           "Draw only the selected ray, its ancestors and its shadow rays.");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(rays.filter.hidden.empty());
    button("Show all", 3, Command::ShowAllRays, "Draw hidden rays again (Shift+H).");
    ImGui::EndDisabled();
    button("Copy JSON", 3, Command::CopyRays, "Copy the ray tree of the sample as JSON (J).");
    ImGui::SameLine();
    button("Export OBJ", 3, Command::ExportRays,
           "Write the rays as line segments to an OBJ file, and as JSON (Ctrl+J).");
    ImGui::SameLine();
    button("Clear", 3, Command::ClearRays, "Discard the recorded rays (C). Ctrl+Z brings them back.");
}

}  // namespace

void drawRayTable(Workspace& workspace, const DebugRays::PixelRecording& recording) {
    DebugRays& rays = workspace.rays;
    const RayTree& tree = recording.tree();
    const std::vector<RaySelection> shown = shownRays(tree, rays.filter);
    dimText(fmt::format("{} of {} rays drawn", shown.size(), tree.nodes.size() + tree.shadowRays.size()));
    static RaySelection revealed;
    const bool reveal = rays.selection() != revealed;
    revealed = rays.selection();
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                       ImGuiTableFlags_BordersOuter | ImGuiTableFlags_Resizable;
    if (ImGui::BeginTable("rays", 3, kFlags, {0.0f, scaled(110.0f)})) {
        ImGui::TableSetupScrollFreeze(0, 1);
        ImGui::TableSetupColumn("ray", ImGuiTableColumnFlags_WidthStretch, 0.38f);
        ImGui::TableSetupColumn("t, hit", ImGuiTableColumnFlags_WidthStretch, 0.43f);
        ImGui::TableSetupColumn("adds", ImGuiTableColumnFlags_WidthStretch, 0.19f);
        ImGui::TableHeadersRow();
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(shown.size()));
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const RaySelection ray = shown[static_cast<std::size_t>(i)];
                const Row row = rowOf(*recording.world, tree, ray);
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::PushID(i);
                if (ui::selectable(row.kind.c_str(), ray == rays.selection(),
                                   ImGuiSelectableFlags_SpanAllColumns))
                    rays.select(ray == rays.selection() ? RaySelection{} : ray);
                ImGui::PopID();
                ImGui::TableNextColumn();
                text(row.where);
                ImGui::TableNextColumn();
                text(row.adds);
            }
        const auto at = std::find(shown.begin(), shown.end(), rays.selection());
        if (reveal && at != shown.end())
            ImGui::SetScrollY(ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(at - shown.begin()) -
                              scaled(40.0f));
        ImGui::EndTable();
    }
    drawActions(workspace);
    const RaySelection selected = rays.selection();
    if (selected.node >= 0) drawNode(*recording.world, tree.nodes[static_cast<std::size_t>(selected.node)]);
    if (selected.shadow >= 0) drawShadowRay(tree.shadowRays[static_cast<std::size_t>(selected.shadow)]);
    if (selected.empty()) dimText("Click a ray for its details.");
}

}  // namespace rayscope::viewer
