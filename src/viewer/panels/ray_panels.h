#pragma once
// Parts of the panel of recorded rays.
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// The rays of the chosen sample as a table in which one can be selected, and everything about that one.
void drawRayTable(Workspace& workspace, const DebugRays::PixelRecording& recording);

/// The traversal of the selected ray through the hierarchy, step by step.
void drawTraversal(Workspace& workspace);

/// Where the samples lie in the pixel, and what each is worth.
void drawPixelSamples(Workspace& workspace, const DebugRays::PixelRecording& recording);
/// Pixels that were pinned, side by side.
void drawPins(Workspace& workspace);

/// Texels, environment, gloss and lens where the selected ray ends.
void drawSurface(Workspace& workspace, const DebugRays::PixelRecording& recording);

}  // namespace rayscope::viewer
