#pragma once
#include <optional>

#include "viewer/model/light_handles.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// The lights where they are, in their colours; signs of constant size on the screen.
OverlayLines lightLines(const std::vector<Light>& lights, int selected, const ViewFrame& frame, double scale);

/// The three-axis handle at `center`: x red, y green, z blue, the part under the cursor bright.
OverlayLines handleLines(const ViewFrame& frame, glm::dvec3 center, std::optional<HandlePart> hovered,
                         const HandleSize& size);

}  // namespace rayscope::viewer
