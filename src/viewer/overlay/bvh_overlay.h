#pragma once
#include <rayscope/accel.h>

#include "viewer/model/indexed_tree.h"
#include "viewer/model/overlay_options.h"
#include "viewer/overlay/boxes.h"

namespace rayscope::viewer {

/// The boxes of the selected level. Those of the `referenceTree` (may be null) come first and are wider and
/// red, so that red is visible only where the boxes of the tree are tighter.
OverlayBoxes levelBoxes(const IndexedTree& own, const IndexedTree* referenceTree,
                        const BvhOverlayOptions& options);

/// The box of a node, and dashed the boxes of its children.
OverlayBoxes nodeBoxes(const bvh::BinaryTree& tree, std::uint32_t node);

/// The outlines of primitives: the edges of triangles, and three great circles of spheres.
OverlayLines primitiveLines(const AccelInput& input, std::span<const std::uint32_t> primitives,
                            glm::vec4 color, float width);

/// The selected leaf: its box and its primitives.
OverlayBoxes leafBoxes(const IndexedTree& own, const BvhOverlayOptions& options);
OverlayLines leafLines(const IndexedTree& own, const AccelInput& input, const BvhOverlayOptions& options);

}  // namespace rayscope::viewer
