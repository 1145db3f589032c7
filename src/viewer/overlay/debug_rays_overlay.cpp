#include "viewer/overlay/debug_rays_overlay.h"

#include <algorithm>
#include <cmath>

#include "math/vectors.h"
#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

namespace {

struct Appearance {
    glm::vec4 color;
    LineStyle style;
};
Appearance appearanceOf(const RayNode& node) {
    if (node.end == RayEnd::BelowSurface) return {palette::kBelowSurfaceRay, LineStyle::Dotted};
    if (!node.hit) return {palette::kMissedRay, LineStyle::Dashed};
    switch (node.kind) {
        case RayKind::Camera:
            return {palette::kCameraRay, LineStyle::Solid};
        case RayKind::Reflection:
            return {palette::kReflectedRay, LineStyle::Solid};
        case RayKind::Glossy:
            return {palette::kReflectedRay, LineStyle::Dashed};
        case RayKind::Transparent:
            break;
    }
    return {palette::kTransmittedRay, LineStyle::Dashed};
}

bool kindIsShown(const RayNode& node, const DebugRayFilter& filter) {
    if (node.end == RayEnd::BelowSurface) return filter.rejected;
    if (!node.hit && !filter.missed) return false;
    switch (node.kind) {
        case RayKind::Camera:
            return filter.camera;
        case RayKind::Reflection:
            return filter.reflections;
        case RayKind::Glossy:
            return filter.glossy;
        case RayKind::Transparent:
            break;
    }
    return filter.transparent;
}

bool visibilityIsShown(Visibility visibility, const DebugRayFilter& filter) {
    if (visibility == Visibility::Occluded) return filter.shadowOccluded;
    return visibility == Visibility::FacingAway ? filter.shadowBehindSurface : filter.shadowVisible;
}

double largestOf(const RgbSum& c) { return std::max({c.x, c.y, c.z}); }

const RgbSum& contributionOf(const RayTree& tree, RaySelection ray) {
    return ray.shadow >= 0 ? tree.shadowRays[static_cast<std::size_t>(ray.shadow)].contribution
                           : tree.nodes[static_cast<std::size_t>(ray.node)].contribution;
}

bool addsEnough(const RgbSum& contribution, const DebugRayFilter& filter) {
    if (filter.minContribution <= 0.0f) return true;
    return largestOf(contribution) >= static_cast<double>(filter.minContribution);
}

bool isAncestor(const RayTree& tree, int node, int target) {
    while (target > node) target = tree.nodes[static_cast<std::size_t>(target)].parent;
    return target == node;
}

/// Whether `ray` is an ancestor or a shadow ray of the selected one.
bool belongsToSelected(const RayTree& tree, RaySelection ray, RaySelection selected) {
    if (selected.shadow >= 0) {
        if (ray.shadow >= 0) return ray.shadow == selected.shadow;
        return isAncestor(tree, ray.node, tree.shadowRays[static_cast<std::size_t>(selected.shadow)].node);
    }
    if (ray.shadow >= 0) return tree.shadowRays[static_cast<std::size_t>(ray.shadow)].node == selected.node;
    return isAncestor(tree, ray.node, selected.node);
}

/// The end of the line of a segment.
glm::vec3 endOf(const RayNode& node, float sceneSize) {
    if (node.hit) return node.position;
    const double length = math::length(node.ray.direction);
    if (!(length > 0.0)) return node.ray.origin;
    return node.ray.origin +
           glm::vec3(glm::dvec3(node.ray.direction) * (static_cast<double>(sceneSize) / length));
}

/// The colour with its largest channel at least half-way up, so that lines of dark colours are visible on
/// black.
glm::vec3 brightened(glm::vec3 color) {
    constexpr float kLeast = 0.6f;
    const float largest = std::max({color.r, color.g, color.b});
    if (largest >= kLeast) return color;
    return largest > 0.0f ? color * (kLeast / largest) : glm::vec3(kLeast);
}

OverlayLine segmentLine(const RayNode& node, const RgbSum& arriving, RayColors colors, float sceneSize) {
    const Appearance look = appearanceOf(node);
    OverlayLine line{node.ray.origin, endOf(node, sceneSize), look.color, look.style, 2.0f};
    const bool seesEnvironment = !node.hit && node.contribution != RgbSum(0.0);
    if (!seesEnvironment && (colors == RayColors::Kind || !node.hit)) return line;
    if (colors == RayColors::IncomingRadiance) {
        line.color = {displayColor(Rgb(arriving)), 1.0f};
    } else {
        line.color = {brightened(displayColor(Rgb(surfaceColor(node)))), 1.0f};
        if (node.hit) line.style = node.opacity < 1.0 ? LineStyle::Dashed : LineStyle::Solid;
    }
    line.width = 2.5f;
    return line;
}

OverlayLine shadowLine(const ShadowRay& ray) {
    switch (ray.visibility) {
        case Visibility::Occluded:
            return {ray.from, ray.to, palette::kOccludedRay, LineStyle::Dotted, 1.5f};
        case Visibility::FacingAway:
            return {ray.from, ray.to, palette::kBehindSurfaceRay, LineStyle::Dotted, 1.0f};
        case Visibility::Attenuated:
            return {ray.from, ray.to, glm::vec4(displayColor(ray.color), 0.9f), LineStyle::Dashed, 1.5f};
        case Visibility::Visible:
            break;
    }
    return {ray.from, ray.to, glm::vec4(displayColor(ray.color), 0.9f), LineStyle::Solid, 1.5f};
}

/// Distance in pixels from the cursor to the part of a segment in front of the camera.
std::optional<double> distanceOnScreen(const ViewFrame& frame, glm::dvec3 a, glm::dvec3 b,
                                       glm::dvec2 cursor) {
    const auto segment = frame.projectSegment(a, b);
    if (!segment) return std::nullopt;
    return distanceToSegment(cursor, (*segment)[0], (*segment)[1]);
}

}  // namespace

bool isShown(const RayTree& tree, RaySelection ray, const DebugRayFilter& filter) {
    const ShadowRay* shadow =
        ray.shadow >= 0 ? &tree.shadowRays[static_cast<std::size_t>(ray.shadow)] : nullptr;
    const RayNode& node = tree.nodes[static_cast<std::size_t>(shadow ? shadow->node : ray.node)];
    if (node.depth > filter.maxDepth) return false;
    if (shadow ? !visibilityIsShown(shadow->visibility, filter) : !kindIsShown(node, filter)) return false;
    if (shadow && filter.light >= 0 && shadow->light != filter.light) return false;
    if (!addsEnough(shadow ? shadow->contribution : node.contribution, filter)) return false;
    if (filter.isolated && !filter.selected.empty() && !belongsToSelected(tree, ray, filter.selected))
        return false;
    return std::find(filter.hidden.begin(), filter.hidden.end(), ray) == filter.hidden.end();
}

std::vector<RaySelection> shownRays(const RayTree& tree, const DebugRayFilter& filter) {
    std::vector<RaySelection> rays;
    std::size_t shadow = 0;
    for (int node = 0; node < static_cast<int>(tree.nodes.size()); ++node) {
        if (isShown(tree, {node, -1}, filter)) rays.push_back({node, -1});
        for (; shadow < tree.shadowRays.size() && tree.shadowRays[shadow].node == node; ++shadow)
            if (isShown(tree, {-1, static_cast<int>(shadow)}, filter))
                rays.push_back({-1, static_cast<int>(shadow)});
    }
    return rays;
}

RayWeights::RayWeights(std::span<const RayTree> trees, const DebugRayFilter& filter) {
    for (const RayTree& tree : trees)
        for (const RaySelection ray : shownRays(tree, filter)) {
            ++rays_;
            if (const double largest = largestOf(contributionOf(tree, ray)); std::isfinite(largest))
                largest_ = std::max(largest_, largest);
        }
}

float RayWeights::opacity(const RayTree& tree, RaySelection ray) const {
    if (rays_ <= kFew) return 1.0f;
    constexpr double kFaintest = 0.06, kLeastShare = 0.3;
    const double crowd = std::sqrt(static_cast<double>(kFew) / static_cast<double>(rays_));
    const double part = largest_ > 0.0 ? largestOf(contributionOf(tree, ray)) / largest_ : 1.0;
    const double weight = kLeastShare + (1.0 - kLeastShare) * std::sqrt(std::clamp(part, 0.0, 1.0));
    return static_cast<float>(std::max(kFaintest, crowd * weight));
}

OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize,
                           const RayWeights& weights) {
    OverlayLines lines;
    const std::vector<RgbSum> arriving = filter.colors == RayColors::IncomingRadiance
                                             ? radianceAlong(tree)
                                             : std::vector<RgbSum>(tree.nodes.size());
    for (const RaySelection ray : shownRays(tree, filter)) {
        const auto index = static_cast<std::size_t>(std::max(ray.node, ray.shadow));
        OverlayLine line = ray.node >= 0
                               ? segmentLine(tree.nodes[index], arriving[index], filter.colors, sceneSize)
                               : shadowLine(tree.shadowRays[index]);
        if (ray != filter.selected) {
            line.color.a *= weights.opacity(tree, ray);
        } else {
            // A halo below leaves colour and style of the ray visible.
            lines.push_back({line.from, line.to, palette::kHalo, LineStyle::Solid, 7.0f});
            line.width = 3.5f;
        }
        lines.push_back(line);
    }
    if (filter.normals)
        for (const RayNode& node : tree.nodes)
            if (node.hit && node.depth <= filter.maxDepth)
                lines.push_back({node.position, node.position + node.normal * (sceneSize / 20.0f),
                                 palette::kNormal, LineStyle::Solid, 2.0f});
    return lines;
}

RaySelection pickRay(const RayTree& tree, const DebugRayFilter& filter, const ViewFrame& frame,
                     glm::dvec2 cursor, double reach, float sceneSize) {
    RaySelection nearest;
    for (const RaySelection ray : shownRays(tree, filter)) {
        const auto index = static_cast<std::size_t>(std::max(ray.node, ray.shadow));
        const glm::vec3 from = ray.node >= 0 ? tree.nodes[index].ray.origin : tree.shadowRays[index].from;
        const glm::vec3 to = ray.node >= 0 ? endOf(tree.nodes[index], sceneSize) : tree.shadowRays[index].to;
        const auto distance = distanceOnScreen(frame, glm::dvec3(from), glm::dvec3(to), cursor);
        if (!distance || *distance > reach) continue;
        reach = *distance;
        nearest = ray;
    }
    return nearest;
}

std::vector<RayLegendEntry> debugRayLegend() {
    using F = DebugRayFilter;
    return {
        {"camera ray", palette::kCameraRay, LineStyle::Solid, &F::camera},
        {"mirror reflection", palette::kReflectedRay, LineStyle::Solid, &F::reflections},
        {"glossy reflection", palette::kReflectedRay, LineStyle::Dashed, &F::glossy},
        {"glossy, below the surface", palette::kBelowSurfaceRay, LineStyle::Dotted, &F::rejected},
        {"transmitted", palette::kTransmittedRay, LineStyle::Dashed, &F::transparent},
        {"miss", palette::kMissedRay, LineStyle::Dashed, &F::missed},
        {"light visible (in its colour)", {1.0f, 1.0f, 1.0f, 0.9f}, LineStyle::Solid, &F::shadowVisible},
        {"light occluded", palette::kOccludedRay, LineStyle::Dotted, &F::shadowOccluded},
        {"light behind the surface", palette::kBehindSurfaceRay, LineStyle::Dotted, &F::shadowBehindSurface},
        {"shading normal", palette::kNormal, LineStyle::Solid, &F::normals},
        {"vertex normals", palette::kVertexNormal, LineStyle::Solid, &F::vertexNormals}};
}

}  // namespace rayscope::viewer
