#include "viewer/overlay/debug_rays_overlay.h"

#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

namespace {

struct Look {
    glm::vec4 color;
    LineStyle style;
};
Look lookOf(RayKind kind) {
    switch (kind) {
        case RayKind::Camera:
            return {palette::kCameraRay, LineStyle::Solid};
        case RayKind::Reflection:
        case RayKind::Glossy:
            return {palette::kReflectedRay, LineStyle::Solid};
        case RayKind::Transparent:
            break;
    }
    return {palette::kTransmittedRay, LineStyle::Dashed};
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
    return {node.ray.origin, node.ray.origin + direction * sceneSize, palette::kMissedRay, LineStyle::Dashed,
            2.0f};
}

OverlayLine shadowLine(const ShadowRay& ray) {
    switch (ray.visibility) {
        case Visibility::Blocked:
            return {ray.from, ray.to, palette::kBlockedRay, LineStyle::Dotted, 1.5f};
        case Visibility::FacingAway:
            return {ray.from, ray.to, palette::kAwayRay, LineStyle::Dotted, 1.0f};
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
                                 palette::kNormal, LineStyle::Solid, 2.0f});
    return lines;
}

std::vector<RayLegendEntry> debugRayLegend() {
    return {{"camera ray", palette::kCameraRay, LineStyle::Solid},
            {"reflection", palette::kReflectedRay, LineStyle::Solid},
            {"behind transparent", palette::kTransmittedRay, LineStyle::Dashed},
            {"misses everything", palette::kMissedRay, LineStyle::Dashed},
            {"shadow ray, light visible: its colour", {1.0f, 1.0f, 1.0f, 0.9f}, LineStyle::Solid},
            {"shadow ray, blocked", palette::kBlockedRay, LineStyle::Dotted},
            {"light behind the surface", palette::kAwayRay, LineStyle::Dotted},
            {"normal", palette::kNormal, LineStyle::Solid}};
}

}  // namespace rayscope::viewer
