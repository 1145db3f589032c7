#pragma once
#include "bvh/layout/wide_tree.h"
#include "probe/traversal_log.h"

namespace rayscope::probe {

/// Traverses the wide tree with log.ray, for any hit if log.anyHit, and records the events. The ray must be
/// traceable.
void recordWideTraversal(const bvh::WideTree& tree, TraversalLog& log);

}  // namespace rayscope::probe
