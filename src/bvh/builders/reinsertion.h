#pragma once
#include "bvh/builders/linked_tree.h"

namespace rayscope::bvh {

/// Making `node` the sibling of `target` reduces the total area of the inner nodes by `gain`.
struct Reinsertion {
    std::uint32_t node = kNoNode, target = kNoNode;
    float gain = 0.0f;
};

/// The best reinsertion of `node`; no target if none has a gain. Goes up the path to the root and searches
/// the sibling subtrees by branch and bound (Meister, Bittner 2018, §3.1), nearer boxes first, up to a
/// limited number of visited nodes.
Reinsertion bestReinsertion(const LinkedTree& tree, std::uint32_t node);

}  // namespace rayscope::bvh
