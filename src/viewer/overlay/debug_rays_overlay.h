#pragma once
#include <rayscope/probe.h>

#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// One of the rays of a tree; at most one of the two numbers is set.
struct RaySelection {
    int node = -1, shadow = -1;
    bool empty() const { return node < 0 && shadow < 0; }
    bool operator==(const RaySelection&) const = default;
};

enum class RayColors {
    Kind,             ///< what the ray is
    Surface,          ///< what the surface that it meets shows of its own
    IncomingRadiance  ///< the radiance that comes along it
};

/// Which of the recorded rays are drawn, and how. A row of the legend switches one of the kinds.
struct DebugRayFilter {
    bool camera = true, reflections = true, glossy = true, transparent = true, missed = true, rejected = true;
    bool shadowVisible = true, shadowOccluded = true, shadowBehindSurface = true;
    bool normals = true, vertexNormals = false;
    int maxDepth = 16;             ///< reflections before a ray
    int light = -1;                ///< only shadow rays to this light; -1: all
    float minContribution = 0.0f;  ///< of the largest channel of what a vertex or shadow ray adds
    RayColors colors = RayColors::Kind;
    bool allSamples = false;  ///< the rays of every sample of the pixel
    bool isolated = false;    ///< only the selected ray, the rays before it and its shadow rays
    RaySelection selected;
    std::vector<RaySelection> hidden;
    bool operator==(const DebugRayFilter&) const = default;
};

bool isShown(const RayTree& tree, RaySelection ray, const DebugRayFilter& filter);

/// The rays that the filter lets through: nodes in order, each followed by its shadow rays.
std::vector<RaySelection> shownRays(const RayTree& tree, const DebugRayFilter& filter);

/// Rays by kind (colour and line style) or in what they see, shadow rays in the light's colour or red where
/// blocked, and shading normals. `sceneSize` is the length of the scene's diagonal: rays that miss are drawn
/// that long, normals a twentieth of it.
OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize);

/// The shown ray that appears within `reach` pixels of the cursor; of several the nearest.
RaySelection pickRay(const RayTree& tree, const DebugRayFilter& filter, const ViewFrame& frame,
                     glm::dvec2 cursor, double reach, float sceneSize);

/// What a line means, and the switch for it.
struct RayLegendEntry {
    const char* label;
    glm::vec4 color;
    LineStyle style;
    bool DebugRayFilter::*shown;
};
std::vector<RayLegendEntry> debugRayLegend();

}  // namespace rayscope::viewer
