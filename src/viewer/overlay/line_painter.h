#pragma once
// Lines on the processor: where OpenGL runs there, too, ten thousand lines take it many times as long as
// this, which does nothing but lines one pixel wide.
#include <cstdint>

#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// A picture in memory with the depths of what it shows. Rows go upwards, as OpenGL has them.
struct PaintCanvas {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;  ///< red in the lowest byte, then green, blue, alpha
    std::vector<float> depth;  ///< 0 … 1 from the near to the far plane; empty: nothing hides lines
};

struct PaintOptions {
    glm::mat4 viewProjection{1.0f};  ///< to OpenGL clip coordinates
    float unit = 1.0f;               ///< pixels of the canvas per unit of the patterns of dashes and dots
    float hiddenOpacity = 1.0f;      ///< multiplies the opacity of what lies behind surfaces
};

/// Paints lines, then boxes, in the order of the lists, all of them one pixel wide, without softened edges.
/// Patterns and what is hidden are as in shaders/line.frag. Parts outside the view and coordinates that are
/// not finite leave no trace. The canvas has at most 16384 pixels to a side.
void paintLines(PaintCanvas& canvas, const OverlayLines& lines, const PaintOptions& look);
void paintBoxes(PaintCanvas& canvas, const OverlayBoxes& boxes, const PaintOptions& look);

}  // namespace rayscope::viewer
