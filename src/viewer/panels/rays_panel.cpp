#include <fmt/format.h>

#include "probe/names.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"
#include "viewer/theme.h"

namespace rayscope::viewer {

namespace {

ImU32 toU32(glm::vec4 c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, c.w}); }

void drawLegend() {
    for (const RayLegendEntry& entry : debugRayLegend()) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float y = at.y + 0.5f * ImGui::GetTextLineHeight(), length = scaled(26.0f);
        const float dash = entry.style == LineStyle::Solid    ? length
                           : entry.style == LineStyle::Dashed ? scaled(6.0f)
                                                              : scaled(2.0f);
        for (float x = 0.0f; x < length; x += 1.7f * dash)
            ImGui::GetWindowDrawList()->AddLine({at.x + x, y}, {at.x + std::min(x + dash, length), y},
                                                toU32(entry.color), scaled(2.0f));
        ImGui::Dummy({length, ImGui::GetTextLineHeight()});
        ImGui::SameLine();
        text(entry.label);
    }
}

void drawFilter(DebugRayFilter& filter) {
    ImGui::Checkbox("Camera", &filter.camera);
    ImGui::SameLine(scaled(110.0f));
    ImGui::Checkbox("Reflections", &filter.reflections);
    ImGui::SameLine(scaled(225.0f));
    ImGui::Checkbox("Normals", &filter.normals);
    ImGui::Checkbox("Shadow", &filter.shadow);
    ImGui::SameLine(scaled(110.0f));
    ImGui::Checkbox("Transparent", &filter.transparent);
    labelledRow("Depth up to");
    ImGui::SliderInt("##depth", &filter.maxDepth, 0, 16, "%d", ImGuiSliderFlags_AlwaysClamp);
}

std::string rgbText(const RgbSum& c) { return fmt::format("{:.4g}  {:.4g}  {:.4g}", c.r, c.g, c.b); }

/// The proof that the rays shown are those of the picture.
void drawVerdict(const ReplayVerdict& verdict) {
    if (verdict.samples == 0) return;
    const bool good = verdict.matchesFilm && verdict.addsUp;
    coloredText(good ? kGoodText : kErrorText,
                good ? fmt::format("Replay of {} samples: same bits as the picture", verdict.samples)
                     : "The replay differs from the picture");
    if (good) return;
    text("Picture: " + rgbText(verdict.film));
    text("Replay:  " + rgbText(verdict.replayed));
}

void drawNode(const DebugRays::Shot& shot, int index) {
    const RayNode& node = shot.tree.nodes[static_cast<std::size_t>(index)];
    const std::string label =
        fmt::format("{} {}  {}", nameOf(node.kind), node.depth,
                    node.hit ? fmt::format("t {:.5g}", node.primitiveHit.t) : std::string(nameOf(node.end)));
    ImGui::PushID(index);
    if (ImGui::TreeNodeEx("node", ImGuiTreeNodeFlags_DefaultOpen, "%s", label.c_str())) {
        if (node.hit)
            dimText(fmt::format("{}, primitive {}", objectName(*shot.world, node.object),
                                node.primitiveHit.primitive));
        dimText("adds " + rgbText(node.contribution));
        int visible = 0, blocked = 0, away = 0;
        for (const ShadowRay& ray : shot.tree.shadowRays) {
            if (ray.node != index) continue;
            if (ray.visibility == Visibility::Blocked)
                ++blocked;
            else if (ray.visibility == Visibility::FacingAway)
                ++away;
            else
                ++visible;
        }
        if (visible + blocked + away > 0)
            dimText(fmt::format("shadow rays: {} free, {} blocked, {} behind", visible, blocked, away));
        for (int child = index + 1; child < static_cast<int>(shot.tree.nodes.size()); ++child)
            if (shot.tree.nodes[static_cast<std::size_t>(child)].parent == index) drawNode(shot, child);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void drawShot(Workspace& workspace, const DebugRays::Shot& shot) {
    const RayTree& tree = shot.tree;
    text(fmt::format("Pixel {}, {}", tree.name.x, tree.name.y));
    if (workspace.rays.staleFor(workspace.edit, workspace.imageSize()))
        coloredText(kWarningText, "Stale: camera, scene or settings have changed");
    int sample = tree.name.index;
    labelledRow("Sample");
    if (ImGui::SliderInt("##sample", &sample, 0, std::max(0, shot.state.settings.spp - 1), "%d",
                         ImGuiSliderFlags_AlwaysClamp)) {
        const DebugRays::Shot before = shot;
        workspace.rays.shoot(before.world, before.state, before.imageSize, {tree.name.x, tree.name.y, sample},
                             nullptr);
        return;
    }
    tooltip("Which sample of the pixel the rays belong to.");
    labelledRow("Radiance");
    text(rgbText(tree.radiance));
    labelledRow("Recorded");
    text(fmt::format("{} rays, {} shadow rays", tree.nodes.size(), tree.shadowRays.size()));
    if (shot.verdict) drawVerdict(*shot.verdict);
    if (ImGui::Button("Clear", {-1.0f, 0.0f})) {
        workspace.rays.clear();
        return;
    }
    if (ImGui::TreeNodeEx("Tree", ImGuiTreeNodeFlags_DefaultOpen)) {
        for (int i = 0; i < static_cast<int>(tree.nodes.size()); ++i)
            if (tree.nodes[static_cast<std::size_t>(i)].parent < 0) drawNode(shot, i);
        ImGui::TreePop();
    }
}

}  // namespace

void drawRaysPanel(Workspace& workspace) {
    if (ImGui::CollapsingHeader("Recorded rays", ImGuiTreeNodeFlags_DefaultOpen)) {
        if (const DebugRays::Shot* shot = workspace.rays.shot())
            drawShot(workspace, *shot);
        else
            wrappedText("Point at a pixel and press R: its rays are recorded, drawn and listed here.");
        ImGui::Spacing();
    }
    if (ImGui::CollapsingHeader("Shown", ImGuiTreeNodeFlags_DefaultOpen)) {
        drawFilter(workspace.rays.filter);
        ImGui::Spacing();
    }
    if (ImGui::CollapsingHeader("Legend", ImGuiTreeNodeFlags_DefaultOpen)) drawLegend();
}

}  // namespace rayscope::viewer
