#include "viewer/overlay/overlay.h"

#include <rayscope/display.h>
#include <algorithm>

namespace rayscope::viewer {

void appendBox(OverlayLines& lines, glm::vec3 lower, glm::vec3 upper, glm::vec4 color, LineStyle style,
               float width) {
    const auto corner = [&](int bits) {
        return glm::vec3(bits & 1 ? upper.x : lower.x, bits & 2 ? upper.y : lower.y,
                         bits & 4 ? upper.z : lower.z);
    };
    for (int start = 0; start < 8; ++start)
        for (int axis = 1; axis < 8; axis *= 2)
            if (!(start & axis)) lines.push_back({corner(start), corner(start | axis), color, style, width});
}

glm::vec3 displayColor(Rgb linear) {
    const float largest = std::max({linear.r, linear.g, linear.b, 1.0f});
    return glm::min(toDisplay(glm::max(linear, Rgb(0.0f)) / largest), Rgb(1.0f));
}

}  // namespace rayscope::viewer
