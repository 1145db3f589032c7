#pragma once
#include <rayscope/accel.h>

#include "probe/tree_index.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// What is drawn of a bounding volume hierarchy.
struct BvhOverlayOptions {
    bool levels = false;                ///< boxes of one level …
    int level = 0;                      ///< … this one
    bool leavesAbove = false;           ///< and the leaves that end above it
    bool showReference = false;         ///< the boxes of the referenceTree tree on the same level below them
    bool leaf = false;                  ///< one leaf with its primitives …
    int leafNumber = 0;                 ///< … by its place in preorder
    std::uint32_t node = bvh::kNoNode;  ///< the selected node
    bool any() const { return levels || showReference || leaf || node != bvh::kNoNode; }
    bool operator==(const BvhOverlayOptions&) const = default;
};

/// A tree with what is known about it.
struct IndexedTree {
    const bvh::BinaryTree& tree;
    const probe::TreeIndex& index;
};

/// The boxes of the chosen level. Those of the `referenceTree` (may be null) come first and are wider and
/// red, so that red shows only where the tree has saved space.
OverlayBoxes levelBoxes(const IndexedTree& own, const IndexedTree* referenceTree,
                        const BvhOverlayOptions& choice);

/// The box of a node, and the boxes of its children dashed.
OverlayBoxes nodeBoxes(const bvh::BinaryTree& tree, std::uint32_t node);

/// The outlines of primitives: the edges of triangles, and three great circles of spheres.
OverlayLines primitiveLines(const AccelInput& input, std::span<const std::uint32_t> primitives,
                            glm::vec4 color, float width);

/// The chosen leaf: its box and its primitives.
OverlayBoxes leafBoxes(const IndexedTree& own, const BvhOverlayOptions& choice);
OverlayLines leafLines(const IndexedTree& own, const AccelInput& input, const BvhOverlayOptions& choice);

}  // namespace rayscope::viewer
