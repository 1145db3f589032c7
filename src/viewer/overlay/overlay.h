#pragma once
// Elements of overlays. An overlay is a pure function from recorded data to a list of them, so it can be
// tested without a window.
#include <rayscope/vector.h>
#include <vector>

namespace rayscope::viewer {

enum class LineStyle { Solid, Dashed, Dotted };

/// A segment in the scene. The colour is display-referred (sRGB, 0 … 1), the width in pixels at scale 1.
struct OverlayLine {
    glm::vec3 from{0.0f}, to{0.0f};
    glm::vec4 color{1.0f};
    LineStyle style = LineStyle::Solid;
    float width = 1.5f;
};

using OverlayLines = std::vector<OverlayLine>;

/// The twelve edges of an axis-aligned box.
void appendBox(OverlayLines& lines, glm::vec3 lower, glm::vec3 upper, glm::vec4 color,
               LineStyle style = LineStyle::Solid, float width = 1.0f);

/// Display value of a linear colour: scaled into 0 … 1, which keeps its hue, then encoded as sRGB.
glm::vec3 displayColor(Rgb linear);

}  // namespace rayscope::viewer
