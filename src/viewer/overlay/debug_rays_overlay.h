#pragma once
#include <rayscope/probe.h>
#include <span>

#include "viewer/model/overlay_options.h"
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

bool isShown(const RayTree& tree, RaySelection ray, const DebugRayFilter& filter);

/// The rays that the filter shows: nodes in order, each followed by its shadow rays.
std::vector<RaySelection> shownRays(const RayTree& tree, const DebugRayFilter& filter);

/// How strongly rays are drawn: opaque if they are few, else the more transparent the more they are and the
/// less they add to their sample.
class RayWeights {
  public:
    RayWeights() = default;
    /// Of all rays that the filter shows.
    RayWeights(std::span<const RayTree> trees, const DebugRayFilter& filter);
    float opacity(const RayTree& tree, RaySelection ray) const;

  private:
    static constexpr std::size_t kFew = 64;
    std::size_t rays_ = 0;
    double largest_ = 0.0;  ///< contribution
};

/// Rays coloured as RayColors says, shadow rays in the colour of the light or red if occluded, and shading
/// normals. `sceneSize` is the length of the scene's diagonal: rays that miss are drawn with that length,
/// normals with a twentieth of it.
OverlayLines debugRayLines(const RayTree& tree, const DebugRayFilter& filter, float sceneSize,
                           const RayWeights& weights = {});

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
