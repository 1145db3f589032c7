#pragma once
#include <rayscope/accel.h>

#include "viewer/model/indexed_tree.h"
#include "viewer/model/overlay_options.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

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
