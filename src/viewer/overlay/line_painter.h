#pragma once
// A line rasteriser for OpenGL drivers that run on the CPU, where lines are slow. Median time per frame with
// Mesa's llvmpipe on two cores (1280x720 window, orbiting at half resolution): with 9,400 ray lines 22 ms
// instead of 115 ms, with the edges of 1,000 boxes 15 ms instead of 27 ms; with 1,000 lines there is no
// difference.
#include <cstdint>

#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// A picture in memory with its depth buffer. The lowest row comes first, as in OpenGL.
struct PaintCanvas {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;  ///< red in the lowest byte, then green, blue, alpha
    std::vector<float> depth;           ///< 0 … 1 from the near to the far plane; empty: no line is hidden
};

struct PaintOptions {
    glm::mat4 viewProjection{1.0f};  ///< to OpenGL clip coordinates
    float unit = 1.0f;               ///< pixels of the canvas per unit of the patterns of dashes and dots
    float hiddenOpacity = 1.0f;      ///< multiplies the opacity of hidden parts
};

/// Draw in the order of the list, one pixel wide, without antialiasing. Line styles and the depth test are
/// those of shaders/line.frag. Parts outside the view frustum and non-finite coordinates are not drawn. The
/// canvas has at most 16384 pixels to a side.
void paintLines(PaintCanvas& canvas, const OverlayLines& lines, const PaintOptions& look);
void paintBoxes(PaintCanvas& canvas, const OverlayBoxes& boxes, const PaintOptions& look);

}  // namespace rayscope::viewer
