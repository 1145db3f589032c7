#pragma once
#include "viewer/overlay/overlay.h"
#include "viewer/projection.h"

namespace rayscope::viewer {

/// An axis-aligned box of the scene, drawn as its edges.
struct OverlayBox {
    glm::vec3 lower{0.0f}, upper{0.0f};
    glm::vec4 color{1.0f};
    LineStyle style = LineStyle::Solid;
    float width = 1.0f;
};
using OverlayBoxes = std::vector<OverlayBox>;

struct BoxLines {
    OverlayLines lines;
    std::size_t large = 0;  ///< boxes of some pixels in the picture …
    std::size_t whole = 0;  ///< … and how many of them have all their edges
};

/// Boxes as they can be told apart from where the camera stands: those of some pixels have twelve edges, but
/// no more than the `mostWhole` largest; of the others one per spot of the picture is drawn, as a stroke;
/// those outside the picture are left out. So the number of lines is bounded, whatever the number of boxes.
BoxLines boxLines(const OverlayBoxes& boxes, const ViewFrame& frame, std::size_t mostWhole = 20000);

}  // namespace rayscope::viewer
