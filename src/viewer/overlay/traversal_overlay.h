#pragma once
#include <rayscope/accel.h>

#include "probe/traversal_log.h"
#include "viewer/model/overlay_options.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// How many steps of the log the choice shows.
std::size_t shownSteps(const probe::TraversalLog& log, const TraversalOverlayOptions& choice);

/// Entered boxes green, culled ones purple, waiting ones orange and dashed, missed ones grey and dotted; the
/// one that is searched at the moment is drawn thick.
OverlayBoxes traversalBoxes(const probe::TraversalLog& log, const TraversalOverlayOptions& choice);

/// The primitive that is the closest hit so far, the one that was tested last, and the interval of the ray in
/// which hits still count, drawn as far as the scene reaches.
OverlayLines traversalLines(const probe::TraversalLog& log, const AccelInput& input,
                            const TraversalOverlayOptions& choice, float sceneSize);

}  // namespace rayscope::viewer
