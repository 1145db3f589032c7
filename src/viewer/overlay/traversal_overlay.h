#pragma once
#include <rayscope/accel.h>

#include "probe/traversal_log.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// What is drawn of a traversal.
struct TraversalOverlayOptions {
    bool shown = false;
    bool culled = true;     ///< boxes that were hit, but lie behind a hit
    bool missed = false;    ///< boxes that the ray does not meet
    bool stepping = false;  ///< as it stands after `step` steps, not at the end
    int step = 0;
    BvhLayout layout = BvhLayout::Binary;  ///< of the tree that is searched
    bool operator==(const TraversalOverlayOptions&) const = default;
};

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
