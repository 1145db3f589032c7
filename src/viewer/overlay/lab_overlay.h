#pragma once
#include <rayscope/lab.h>

#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// The rays that went wrong with a method, brought back from their testPoints to the scene as it is: leaks
/// and double hits as solid lines of the scene's size, what went wrong next to a surface dashed and shorter.
OverlayLines labFailureLines(const LabResult& result, LabMethod method);

}  // namespace rayscope::viewer
