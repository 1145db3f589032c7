#pragma once
#include "viewer/model/projection.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// An axis-aligned box of the scene, drawn as its edges.
struct OverlayBox {
    glm::vec3 lower{0.0f}, upper{0.0f};
    glm::vec4 color{1.0f};
    LineStyle style = LineStyle::Solid;
    float width = 1.0f;
};
using OverlayBoxes = std::vector<OverlayBox>;

struct BoxSelection {
    OverlayBoxes whole;     ///< of which all edges are drawn
    OverlayLines strokes;   ///< that stand for small boxes
    std::size_t large = 0;  ///< boxes of some pixels in the picture, whether drawn whole or not
};

/// Boxes as they can be told apart from where the camera stands, with the pixels that `frame` has: those of
/// some pixels have twelve edges, but no more than the `maxWholeBoxes` largest; of the others one per spot of
/// the picture is drawn, as a stroke; those outside the picture are left out. So the number of lines is
/// bounded, whatever the number of boxes.
BoxSelection selectBoxes(const OverlayBoxes& boxes, const ViewFrame& frame,
                         std::size_t maxWholeBoxes = 20000);

}  // namespace rayscope::viewer
