#pragma once
#include <rayscope/probe.h>

#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// Which of the recorded rays are drawn.
struct DebugRayFilter {
    bool camera = true, reflections = true, transparent = true, shadow = true, normals = true;
    int maxDepth = 16;  ///< reflections before a ray
    bool operator==(const DebugRayFilter&) const = default;
};

/// Rays by kind (colour and line style), shadow rays in the light's colour or red where blocked, and shading
/// normals. `sceneSize` is the length of the scene's diagonal: rays that miss are drawn that long, normals a
/// twentieth of it.
OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize);

/// What a line means, for the legend.
struct RayLegendEntry {
    const char* label;
    glm::vec4 color;
    LineStyle style;
};
std::vector<RayLegendEntry> debugRayLegend();

}  // namespace rayscope::viewer
