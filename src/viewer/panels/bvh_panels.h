#pragma once
// Parts of the BVH panel.
#include <string_view>

#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

std::string_view nameOf(BvhBuilder builder);

/// Builder settings of the reference tree, and the cost of both trees.
void drawReferenceTree(Workspace& workspace, const BvhInspector::InspectedTree& inspected);

/// SAH cost of the selected node over all candidate split planes.
void drawSplitCurve(BvhInspector& bvh, int bins);

}  // namespace rayscope::viewer
