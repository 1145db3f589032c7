#pragma once
#include <rayscope/accel.h>
#include <vector>

#include "bvh/binary_tree.h"
#include "bvh/kernel/wide_layout.h"

namespace rayscope::bvh {

/// Owns the data of a kernel::WideTreeView.
struct WideTree {
    base::BigVector<kernel::WideNode> nodes;
    base::BigVector<kernel::TriangleBlock> blocks;
    std::vector<kernel::SphereRecord> spheres;
    kernel::ChildRef root = 0;
    float maxCoordinate = 0.0f;

    kernel::WideTreeView view() const {
        return {nodes.data(), blocks.data(), spheres.data(), root, maxCoordinate};
    }
    std::size_t bytes() const;
};

/// Collapses a binary tree that is not empty to nodes of eight children, such that the SAH cost is least
/// (dynamic programming over the binary tree: Ylitie, Karras, Laine 2017, §3). Throws std::length_error if
/// there are more leaves than a ChildRef can address.
WideTree collapse(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop);

}  // namespace rayscope::bvh
