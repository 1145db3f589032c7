#pragma once
#include "probe/tree_index.h"

namespace rayscope::viewer {

/// A BVH and its index. Both belong to others and must outlive this.
struct IndexedTree {
    const bvh::BinaryTree& tree;
    const probe::TreeIndex& index;
};

}  // namespace rayscope::viewer
