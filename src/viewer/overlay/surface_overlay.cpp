#include "viewer/overlay/surface_overlay.h"

#include <span>

#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

namespace {

void appendLoop(OverlayLines& lines, std::span<const glm::vec3> corners, glm::vec4 color, LineStyle style,
                float width) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        lines.push_back({corners[i], corners[(i + 1) % corners.size()], color, style, width});
}

}  // namespace

OverlayLines vertexNormalLines(const probe::VertexNormals& normals, float length) {
    OverlayLines lines;
    appendLoop(lines, normals.position, palette::kVertexNormal, LineStyle::Solid, 1.5f);
    for (int i = 0; i < 3; ++i)
        lines.push_back({normals.position[i], normals.position[i] + length * normals.normal[i],
                         palette::kVertexNormal, LineStyle::Dashed, 2.0f});
    return lines;
}

OverlayLines glossySquareLines(const probe::GlossySquare& square) {
    OverlayLines lines;
    const glm::vec3 corners[] = {
        square.center - square.right - square.up, square.center + square.right - square.up,
        square.center + square.right + square.up, square.center - square.right + square.up};
    appendLoop(lines, corners, palette::kGlossySquare, LineStyle::Solid, 2.5f);
    lines.push_back({corners[0], corners[2], palette::kGlossySquare, LineStyle::Solid, 1.5f});
    lines.push_back({square.origin, square.center, palette::kGlossySquare, LineStyle::Dotted, 1.5f});
    return lines;
}

OverlayLines environmentLines(const probe::EnvironmentPoint& point, glm::vec3 from, float length) {
    const glm::vec3 direction = glm::vec3(glm::normalize(point.direction));
    return {{from, from + length * direction, glm::vec4(displayColor(point.color), 1.0f), LineStyle::Dashed,
             2.5f}};
}

OverlayLines lensLines(const probe::LensReport& lens) {
    OverlayLines lines;
    appendLoop(lines, lens.outline, palette::kLens, LineStyle::Solid, 2.0f);
    appendLoop(lines, lens.focus, palette::kLens, LineStyle::Solid, 2.0f);
    for (const auto& plane : lens.sharpZone)
        appendLoop(lines, plane, palette::kLens, LineStyle::Dashed, 1.5f);
    return lines;
}

}  // namespace rayscope::viewer
