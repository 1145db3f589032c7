#pragma once
// Parts of the panel Rays.
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// The rays of the selected sample as a table, and the details of the selected ray.
void drawRayTable(Workspace& workspace, const DebugRays::PixelRecording& recording);

/// The BVH traversal of the selected ray, step by step.
void drawTraversal(Workspace& workspace);

/// Positions of the samples in the pixel, and the radiance of each.
void drawPixelSamples(Workspace& workspace, const DebugRays::PixelRecording& recording);
/// Statistics of the pinned pixels.
void drawPins(Workspace& workspace);

/// Texels, environment, glossy lobe, vertex normals and lens at the end of the selected ray.
void drawSurface(Workspace& workspace, const DebugRays::PixelRecording& recording);

}  // namespace rayscope::viewer
