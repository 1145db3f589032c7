#pragma once
#include <rayscope/lab.h>

#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// The rays of a method's failures, transformed from their test points back to the scene: leaks and double
/// hits as solid lines of the scene's size, failures next to a surface as shorter dashed lines.
OverlayLines labFailureLines(const LabResult& result, LabMethod method);

}  // namespace rayscope::viewer
