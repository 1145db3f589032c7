#pragma once
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// From this width on a line is meant to stand out: what is selected, and what is hit.
inline constexpr float kBoldWidth = 3.0f;
inline bool isBold(const OverlayLine& line) { return line.width >= kBoldWidth; }

/// What it takes to draw lines one pixel wide, in pixels: their lengths within the picture, and for each line
/// what it takes to begin one.
double drawingCost(const OverlayLines& lines, const ViewFrame& frame);

/// As many of the lines as cost no more than `maxPixels`, all of them if that is enough. Of lines that
/// appear at the same place one is kept, of the rest an even choice; bold lines are always kept. The choice
/// changes little when the camera moves.
OverlayLines selectLines(const OverlayLines& lines, const ViewFrame& frame, double maxPixels);

}  // namespace rayscope::viewer
