// Where the recorded and the pinned pixels are in the picture.
#include <fmt/format.h>

#include "viewer/model/projection.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

/// The surface that was hit, seen by the current camera.
std::optional<glm::vec2> projected(const Workspace& workspace, const std::optional<glm::vec3>& surface) {
    if (!surface) return std::nullopt;
    const ViewFrame frame = viewFrame(workspace.edit.camera, workspace.viewSize.x, workspace.viewSize.y);
    const auto pixel = frame.project(glm::dvec3(*surface));
    return pixel ? std::optional(glm::vec2(*pixel)) : std::nullopt;
}

std::optional<glm::vec3> surfaceOf(const RayTree& tree) {
    if (tree.nodes.empty() || !tree.nodes.front().hit) return std::nullopt;
    return tree.nodes.front().position;
}

}  // namespace

std::vector<PixelMark> pixelMarks(const Workspace& workspace) {
    std::vector<PixelMark> marks;
    const auto add = [&](const std::optional<glm::vec3>& surface, std::string label, bool recorded) {
        const auto at = projected(workspace, surface);
        if (!at || at->x < 0.0f || at->y < 0.0f) return;
        if (at->x < static_cast<float>(workspace.viewSize.x) &&
            at->y < static_cast<float>(workspace.viewSize.y))
            marks.push_back({*at, std::move(label), recorded});
    };
    for (std::size_t i = 0; i < workspace.rays.pins.size(); ++i)
        add(workspace.rays.pins[i].position, fmt::format("{}", i + 1), false);
    if (const DebugRays::PixelRecording* recording = workspace.rays.recording())
        add(surfaceOf(recording->tree()), "", true);
    return marks;
}

void drawPixelMarks(const Workspace& workspace, glm::vec2 origin, double unit) {
    if (!workspace.view.overlay) return;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    for (const PixelMark& mark : pixelMarks(workspace)) {
        const glm::vec2 at = origin + mark.pixel / static_cast<float>(unit);
        const float radius = scaled(mark.recorded ? 7.0f : 5.0f);
        const ImU32 color = mark.recorded ? IM_COL32_WHITE : IM_COL32(230, 159, 0, 255);
        draw.AddCircle({at.x, at.y}, radius, IM_COL32(0, 0, 0, 200), 0, scaled(3.0f));
        draw.AddCircle({at.x, at.y}, radius, color, 0, scaled(1.5f));
        if (!mark.label.empty())
            pictureLabel(mark.label.c_str(), {at.x + radius + scaled(3.0f), at.y - scaled(9.0f)});
    }
}

}  // namespace rayscope::viewer
