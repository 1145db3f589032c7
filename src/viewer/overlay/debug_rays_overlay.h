#pragma once
#include <rayscope/probe.h>

#include "viewer/model/overlay_options.h"
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

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
