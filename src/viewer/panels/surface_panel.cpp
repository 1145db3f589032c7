// Lookups at the end of the selected ray: texels, environment, glossy lobe, vertex normals, lens.
#include <fmt/format.h>

#include <algorithm>

#include "probe/surface_report.h"
#include "viewer/overlay/overlay.h"
#include "viewer/panels/ray_panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// The four texels as squares with their weights, the hit point as a circle, and the filtered colour.
void drawTexels(const probe::TexelQuad& quad) {
    const float side = scaled(44.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    double x = 0.0, y = 0.0;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            const ImVec2 corner{at.x + side * static_cast<float>(column),
                                at.y + side * static_cast<float>(row)};
            const glm::vec3 color = displayColor(quad.color[row][column]);
            draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, toU32(color));
            const ImU32 ink =
                color.r + color.g + color.b > 1.5f ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255);
            draw.AddText({corner.x + scaled(4.0f), corner.y + scaled(3.0f)}, ink,
                         fmt::format("{:.3f}", quad.weight[row][column]).c_str());
            x += quad.weight[row][column] * (column + 0.5);
            y += quad.weight[row][column] * (row + 0.5);
        }
    const ImVec2 hit{at.x + side * static_cast<float>(x), at.y + side * static_cast<float>(y)};
    draw.AddCircle(hit, scaled(5.0f), IM_COL32(0, 0, 0, 255), 0, scaled(3.0f));
    draw.AddCircle(hit, scaled(5.0f), IM_COL32(255, 255, 255, 255), 0, scaled(1.5f));
    const ImVec2 result{at.x + 2.0f * side + scaled(10.0f), at.y};
    draw.AddRectFilled(result, {result.x + side, result.y + 2.0f * side}, toU32(displayColor(quad.result)));
    ImGui::Dummy({3.0f * side + scaled(10.0f), 2.0f * side});
    ui::note("Texels");
    text(fmt::format("texels {}..{} x {}..{} of {} x {}", quad.x[0], quad.x[1], quad.y[0], quad.y[1],
                     quad.width, quad.height));
    text(fmt::format("uv {:.5g}, {:.5g}", quad.uv.x, quad.uv.y));
    tooltip("Left: the four texels and their weights. Right: the filtered colour.");
}

void drawEnvironment(const probe::EnvironmentPoint& point) {
    if (point.face >= 0)
        text(fmt::format("environment: face {}, s {:.4f} t {:.4f}", probe::faceName(point.face), point.s,
                         point.t));
    else
        text(fmt::format("environment: longitude {:.1f}, latitude {:.1f}", point.s, point.t));
    text(fmt::format("colour {:.4g}  {:.4g}  {:.4g}", point.color.r, point.color.g, point.color.b));
}

}  // namespace

void drawSurface(Workspace& workspace, const DebugRays::PixelRecording& recording) {
    const RayTree& tree = recording.tree();
    const int number = std::max(workspace.rays.selection().node, 0);
    const RayNode& node = tree.nodes[static_cast<std::size_t>(number)];
    bool any = false;
    if (const auto quad = probe::texelsOf(*recording.world, node)) drawTexels(*quad), any = true;
    if (const auto point = probe::environmentOf(*recording.world, node)) drawEnvironment(*point), any = true;
    if (const auto square = probe::glossySquareOf(*recording.world, tree, number)) {
        text(fmt::format("glossy: {} rays, {} below the surface", square->rays, square->rejected));
        text(fmt::format("square at distance 0.3, half side {:.4g}", glm::length(square->right)));
        any = true;
    }
    if (const auto normals = probe::vertexNormalsOf(*recording.world, node, tree.time)) {
        text(fmt::format("normal: weights {:.3f} {:.3f} {:.3f}", normals->weight[0], normals->weight[1],
                         normals->weight[2]));
        any = true;
    }
    if (const auto lens = probe::lensOf(*recording.world)) {
        text(fmt::format("lens: radius {:.4g}, focus at {:.4g}", recording.world->camera.lensRadius(),
                         recording.world->camera.focusDistance()));
        any = true;
    }
    if (!any) dimText("No lookups at the end of this ray.");
    SurfaceOverlayOptions& choice = workspace.rays.surface;
    ui::checkbox("Glossy square", &choice.glossySquare);
    ImGui::SameLine();
    ui::checkbox("Lens and focus", &choice.lens);
}

}  // namespace rayscope::viewer
