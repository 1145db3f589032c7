#pragma once
// Parts of the panel of recorded rays.
#include "viewer/workspace.h"

namespace rayscope::viewer {

/// The rays of the chosen sample as a table in which one can be selected, and everything about that one.
void drawRayTable(Workspace& workspace, const DebugRays::Shot& shot);

/// The search of the selected ray through the hierarchy, step by step.
void drawSearch(Workspace& workspace);

}  // namespace rayscope::viewer
