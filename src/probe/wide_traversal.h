#pragma once
#include "bvh/layout/wide_tree.h"
#include "probe/traversal_log.h"

namespace rayscope::probe {

/// Walks the wide tree with the ray of the log, for any hit if the log says so, and writes down what the walk
/// does. The ray must be traceable.
void recordWideTraversal(const bvh::WideTree& tree, TraversalLog& log);

}  // namespace rayscope::probe
