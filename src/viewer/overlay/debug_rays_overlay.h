#pragma once
#include <rayscope/probe.h>

#include "viewer/model/overlay_options.h"
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

bool isShown(const RayTree& tree, RaySelection ray, const DebugRayFilter& filter);

/// The rays that the filter shows: nodes in order, each followed by its shadow rays.
std::vector<RaySelection> shownRays(const RayTree& tree, const DebugRayFilter& filter);

/// Rays coloured as RayColors says, shadow rays in the colour of the light or red if occluded, and shading
/// normals. `sceneSize` is the length of the scene's diagonal: rays that miss are drawn with that length,
/// normals with a twentieth of it.
OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize);

/// The shown ray nearest to the cursor, at most `reach` pixels away.
RaySelection pickRay(const RayTree& tree, const DebugRayFilter& filter, const ViewFrame& frame,
                     glm::dvec2 cursor, double reach, float sceneSize);

/// The meaning of a line style and colour, and the filter member that shows it.
struct RayLegendEntry {
    const char* label;
    glm::vec4 color;
    LineStyle style;
    bool DebugRayFilter::*shown;
};
std::vector<RayLegendEntry> debugRayLegend();

}  // namespace rayscope::viewer
