#include "viewer/overlay/light_overlay.h"

namespace rayscope::viewer {

namespace {

constexpr int kPieces = 16;  // of a line with a colour gradient

struct Sketch {
    OverlayLines& lines;
    const ViewFrame& frame;
    double scale;
    bool selected;

    float width() const { return selected ? 3.0f : 2.0f; }
    glm::vec4 colorOf(Rgb color) const { return {displayColor(color), 1.0f}; }

    /// A star of eight strokes around a point, with a radius of `pixels`.
    void star(glm::vec3 center, Rgb color, double pixels) const {
        const float radius = static_cast<float>(pixels * scale * frame.unitsPerPixelAt(center));
        const glm::vec3 right(frame.right), up(frame.up);
        for (const glm::vec3 arm : {right, up, (right + up) * 0.7f, (right - up) * 0.7f}) {
            lines.push_back({center + arm * (0.45f * radius), center + arm * radius, colorOf(color),
                             LineStyle::Solid, width()});
            lines.push_back({center - arm * (0.45f * radius), center - arm * radius, colorOf(color),
                             LineStyle::Solid, width()});
        }
    }
    void gradient(glm::vec3 a, glm::vec3 b, Rgb colorA, Rgb colorB) const {
        const auto mix = [](auto p, auto q, int step) {
            return p + (q - p) * (static_cast<float>(step) / kPieces);
        };
        for (int i = 0; i < kPieces; ++i)
            lines.push_back(
                {mix(a, b, i), mix(a, b, i + 1), colorOf(mix(colorA, colorB, i)), LineStyle::Solid, width()});
    }
    void dot(glm::vec3 center, Rgb color) const { star(center, color, 5.0); }

    void draw(const PointLight& light) const { star(light.position, light.color, selected ? 13.0 : 10.0); }
    void draw(const SegmentLight& light) const {
        gradient(light.endpoints[0], light.endpoints[1], light.colors[0], light.colors[1]);
        dot(light.endpoints[0], light.colors[0]);
        dot(light.endpoints[1], light.colors[1]);
    }
    void draw(const ParallelogramLight& light) const {
        const glm::vec3 a = light.corner, b = a + light.edges[0], c = a + light.edges[1],
                        d = b + light.edges[1];
        gradient(a, b, light.colors[0], light.colors[1]);
        gradient(a, c, light.colors[0], light.colors[2]);
        gradient(b, d, light.colors[1], light.colors[3]);
        gradient(c, d, light.colors[2], light.colors[3]);
    }
};

}  // namespace

OverlayLines lightLines(const std::vector<Light>& lights, int selected, const ViewFrame& frame,
                        double scale) {
    OverlayLines lines;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Sketch sketch{lines, frame, scale, static_cast<int>(i) == selected};
        std::visit([&](const auto& shape) { sketch.draw(shape); }, lights[i].shape);
    }
    return lines;
}

OverlayLines handleLines(const ViewFrame& frame, glm::dvec3 center, std::optional<HandlePart> hovered,
                         const HandleSize& size) {
    constexpr glm::vec4 kColors[] = {
        {0.93f, 0.33f, 0.31f, 1.0f}, {0.45f, 0.80f, 0.33f, 1.0f}, {0.33f, 0.56f, 0.96f, 1.0f}};
    constexpr glm::vec4 kHovered{1.0f, 0.92f, 0.45f, 1.0f};
    OverlayLines lines;
    for (const HandlePart handlePart : {HandlePart::X, HandlePart::Y, HandlePart::Z}) {
        const glm::vec4 color = hovered == handlePart ? kHovered : kColors[static_cast<int>(handlePart)];
        const glm::dvec3 end = axisEnd(frame, center, handlePart, size);
        lines.push_back({glm::vec3(center), glm::vec3(end), color, LineStyle::Solid, 3.0f});
        // An arrow head of two strokes in the plane that faces the viewer.
        const glm::dvec3 along = (end - center) * 0.16;
        const glm::dvec3 aside = glm::cross(along, center - frame.eye);
        if (!(glm::length(aside) > 0.0)) continue;
        const glm::dvec3 wing = glm::normalize(aside) * (glm::length(along) * 0.5);
        lines.push_back({glm::vec3(end), glm::vec3(end - along + wing), color, LineStyle::Solid, 3.0f});
        lines.push_back({glm::vec3(end), glm::vec3(end - along - wing), color, LineStyle::Solid, 3.0f});
    }
    const glm::vec4 color = hovered == HandlePart::Free ? kHovered : glm::vec4(0.9f, 0.9f, 0.9f, 1.0f);
    const double half = 0.6 * size.reach * frame.unitsPerPixelAt(center);
    const glm::dvec3 r = frame.right * half, u = frame.up * half;
    const glm::dvec3 corners[] = {center - r - u, center + r - u, center + r + u, center - r + u};
    for (int i = 0; i < 4; ++i)
        lines.push_back(
            {glm::vec3(corners[i]), glm::vec3(corners[(i + 1) % 4]), color, LineStyle::Solid, 2.0f});
    return lines;
}

}  // namespace rayscope::viewer
