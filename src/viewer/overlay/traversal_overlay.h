#pragma once
#include <rayscope/accel.h>

#include "probe/traversal_log.h"
#include "viewer/model/overlay_options.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// The number of steps of the log that are shown.
std::size_t shownSteps(const probe::TraversalLog& log, const TraversalOverlayOptions& options);

/// Visited boxes green, culled ones purple, pushed ones orange and dashed, missed ones grey and dotted; the
/// box of the current node is drawn bold.
OverlayBoxes traversalBoxes(const probe::TraversalLog& log, const TraversalOverlayOptions& options);

/// The primitive of the closest hit so far, the primitive tested last, and the ray from tMin to the traversal
/// bound, at most `sceneSize` long.
OverlayLines traversalLines(const probe::TraversalLog& log, const AccelInput& input,
                            const TraversalOverlayOptions& options, float sceneSize);

}  // namespace rayscope::viewer
