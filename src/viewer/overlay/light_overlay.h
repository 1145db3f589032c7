#pragma once
#include <optional>

#include "viewer/model/light_handles.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// Symbols of the lights in their colours, with a constant size on the screen.
OverlayLines lightLines(const std::vector<Light>& lights, int selected, const ViewFrame& frame, double scale);

/// The three-axis handle at `center`: x red, y green, z blue, the part under the cursor bright.
OverlayLines handleLines(const ViewFrame& frame, glm::dvec3 center, std::optional<HandlePart> hovered,
                         const HandleSize& size);

}  // namespace rayscope::viewer
