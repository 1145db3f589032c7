#pragma once
// Parts of the panel of the hierarchy.
#include <string_view>

#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

std::string_view nameOf(BvhBuilder builder);

/// Another build of the same primitives: how it is built, and what the two cost.
void drawReferenceTree(Workspace& workspace, const BvhInspector::InspectedTree& seen);

/// What it would cost to split the selected node elsewhere.
void drawSplitCurve(BvhInspector& bvh, int bins);

}  // namespace rayscope::viewer
