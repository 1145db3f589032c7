#include "viewer/overlay/debug_rays_overlay.h"

namespace rayscope::viewer {

namespace {

// Okabe and Ito's palette, which people with red-green blindness tell apart too.
constexpr glm::vec4 kCameraColor{0.95f, 0.90f, 0.35f, 1.0f};
constexpr glm::vec4 kReflectionColor{0.34f, 0.71f, 0.91f, 1.0f};
constexpr glm::vec4 kTransparentColor{0.85f, 0.55f, 0.80f, 1.0f};
constexpr glm::vec4 kMissColor{0.84f, 0.25f, 0.10f, 1.0f};
constexpr glm::vec4 kBlockedColor{0.95f, 0.16f, 0.12f, 0.9f};
constexpr glm::vec4 kAwayColor{0.55f, 0.57f, 0.60f, 0.6f};
constexpr glm::vec4 kNormalColor{0.10f, 0.78f, 0.55f, 1.0f};

struct Look {
    glm::vec4 color;
    LineStyle style;
};
Look lookOf(RayKind kind) {
    switch (kind) {
        case RayKind::Camera:
            return {kCameraColor, LineStyle::Solid};
        case RayKind::Reflection:
        case RayKind::Glossy:
            return {kReflectionColor, LineStyle::Solid};
        case RayKind::Transparent:
            break;
    }
    return {kTransparentColor, LineStyle::Dashed};
}

bool isShown(const RayNode& node, const DebugRayFilter& filter) {
    if (node.depth > filter.maxDepth) return false;
    if (node.kind == RayKind::Camera) return filter.camera;
    return node.kind == RayKind::Transparent ? filter.transparent : filter.reflections;
}

OverlayLine segmentLine(const RayNode& node, float sceneSize) {
    const Look look = lookOf(node.kind);
    if (node.hit) return {node.ray.origin, node.position, look.color, look.style, 2.0f};
    const float length = glm::length(node.ray.direction);
    const glm::vec3 direction = length > 0.0f ? node.ray.direction / length : node.ray.direction;
    return {node.ray.origin, node.ray.origin + direction * sceneSize, kMissColor, LineStyle::Dashed, 2.0f};
}

OverlayLine shadowLine(const ShadowRay& ray) {
    switch (ray.visibility) {
        case Visibility::Blocked:
            return {ray.from, ray.to, kBlockedColor, LineStyle::Dotted, 1.5f};
        case Visibility::FacingAway:
            return {ray.from, ray.to, kAwayColor, LineStyle::Dotted, 1.0f};
        case Visibility::Attenuated:
            return {ray.from, ray.to, glm::vec4(displayColor(ray.color), 0.9f), LineStyle::Dashed, 1.5f};
        case Visibility::Visible:
            break;
    }
    return {ray.from, ray.to, glm::vec4(displayColor(ray.color), 0.9f), LineStyle::Solid, 1.5f};
}

}  // namespace

OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize) {
    OverlayLines lines;
    for (const RayNode& node : tree.nodes)
        if (isShown(node, filter)) lines.push_back(segmentLine(node, sceneSize));
    if (filter.shadow)
        for (const ShadowRay& ray : tree.shadowRays)
            if (tree.nodes[static_cast<std::size_t>(ray.node)].depth <= filter.maxDepth)
                lines.push_back(shadowLine(ray));
    if (filter.normals)
        for (const RayNode& node : tree.nodes)
            if (node.hit && node.depth <= filter.maxDepth)
                lines.push_back({node.position, node.position + node.normal * (sceneSize / 20.0f),
                                 kNormalColor, LineStyle::Solid, 2.0f});
    return lines;
}

std::vector<RayLegendEntry> debugRayLegend() {
    return {{"camera ray", kCameraColor, LineStyle::Solid},
            {"reflection", kReflectionColor, LineStyle::Solid},
            {"behind transparent", kTransparentColor, LineStyle::Dashed},
            {"misses everything", kMissColor, LineStyle::Dashed},
            {"shadow ray, light visible: its colour", {1.0f, 1.0f, 1.0f, 0.9f}, LineStyle::Solid},
            {"shadow ray, blocked", kBlockedColor, LineStyle::Dotted},
            {"light behind the surface", kAwayColor, LineStyle::Dotted},
            {"normal", kNormalColor, LineStyle::Solid}};
}

}  // namespace rayscope::viewer
