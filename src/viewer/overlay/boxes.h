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
    OverlayBoxes whole;     ///< drawn with all edges
    OverlayLines strokes;   ///< represent small boxes
    std::size_t large = 0;  ///< boxes of several pixels, in `whole` or not
};

/// Level of detail for boxes at the resolution of `frame`: the largest, at most `maxWholeBoxes`, are drawn
/// with twelve edges; of the others one per square of some pixels is drawn, as a stroke; boxes outside the
/// picture are dropped. The number of lines is therefore bounded.
BoxSelection selectBoxes(const OverlayBoxes& boxes, const ViewFrame& frame,
                         std::size_t maxWholeBoxes = 20000);

}  // namespace rayscope::viewer
