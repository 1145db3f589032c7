#pragma once
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// Lines of at least this width mark selections and hits.
inline constexpr float kBoldWidth = 3.0f;
inline bool isBold(const OverlayLine& line) { return line.width >= kBoldWidth; }

/// The cost of drawing lines one pixel wide, in pixels: their lengths within the picture and a constant per
/// line.
double drawingCost(const OverlayLines& lines, const ViewFrame& frame);

/// A subset of the lines with a drawing cost of at most `maxPixels`, or all of them. Of lines with the same
/// appearance one is kept, of the rest an even subset; bold lines are always kept. The subset is stable while
/// the camera moves.
OverlayLines selectLines(const OverlayLines& lines, const ViewFrame& frame, double maxPixels);

}  // namespace rayscope::viewer
