#pragma once
#include "bvh/build/linked_tree.h"

namespace rayscope::bvh {

/// Taking `node` out of its place and making it the sibling of `target` makes the areas of all inner nodes
/// smaller by `gain`.
struct Reinsertion {
    std::uint32_t node = kNoNode, target = kNoNode;
    float gain = 0.0f;
};

/// The most valuable place for `node`; no target if none is better than the present one. Goes up from there
/// and searches what hangs beside the path by branch and bound (Meister, Bittner 2018, §3.1), the nearest
/// boxes first, until a limited number of nodes has been opened.
Reinsertion bestReinsertion(const LinkedTree& tree, std::uint32_t node);

}  // namespace rayscope::bvh
