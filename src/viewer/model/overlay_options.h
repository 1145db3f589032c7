#pragma once
// Which of the recorded rays, traversals, surfaces and BVH nodes the overlays show. The panels edit these,
// the overlays are functions of them.
#include <rayscope/accel.h>
#include <vector>

#include "bvh/binary_tree.h"

namespace rayscope::viewer {

/// One of the rays of a ray tree; at most one of the two indices is set.
struct RaySelection {
    int node = -1, shadow = -1;
    bool empty() const { return node < 0 && shadow < 0; }
    bool operator==(const RaySelection&) const = default;
};

enum class RayColors {
    Kind,             ///< the kind of the ray
    Surface,          ///< surfaceColor() of the hit
    IncomingRadiance  ///< radianceAlong() the ray
};

/// Which of the recorded rays are drawn, and how. Each row of the legend switches one of the kinds.
struct DebugRayFilter {
    bool camera = true, reflections = true, glossy = true, transparent = true, missed = true, rejected = true;
    bool shadowVisible = true, shadowOccluded = true, shadowBehindSurface = true;
    bool normals = true, vertexNormals = false;
    int maxDepth = 16;             ///< reflections before a ray
    int light = -1;                ///< only shadow rays to this light; -1: all
    float minContribution = 0.0f;  ///< of the largest channel of what a vertex or shadow ray adds
    RayColors colors = RayColors::Kind;
    bool allSamples = false;  ///< the rays of every sample of the pixel
    bool isolated = false;    ///< only the selected ray, its ancestors and its shadow rays
    RaySelection selected;
    std::vector<RaySelection> hidden;
    bool operator==(const DebugRayFilter&) const = default;
};

/// What is drawn of a BVH traversal.
struct TraversalOverlayOptions {
    bool shown = false;
    bool culled = true;     ///< boxes behind the closest hit
    bool missed = false;    ///< boxes that the ray misses
    bool stepping = false;  ///< the state after `step` steps instead of the final one
    int step = 0;
    BvhLayout layout = BvhLayout::Binary;  ///< of the tree that is traversed
    bool operator==(const TraversalOverlayOptions&) const = default;
};

/// What is drawn of the sampling of surfaces and of the lens.
struct SurfaceOverlayOptions {
    bool glossySquare = true, environment = true, lens = true;
    bool operator==(const SurfaceOverlayOptions&) const = default;
};

/// What is drawn of a BVH.
struct BvhOverlayOptions {
    bool levels = false;  ///< boxes of `level`
    int level = 0;
    bool leavesAbove = false;           ///< and the leaves above that level
    bool showReference = false;         ///< below them, boxes of the reference tree on the same level
    bool leaf = false;                  ///< one leaf with its primitives
    int leafNumber = 0;                 ///< of that leaf, in preorder
    std::uint32_t node = bvh::kNoNode;  ///< the selected node
    bool any() const { return levels || showReference || leaf || node != bvh::kNoNode; }
    bool operator==(const BvhOverlayOptions&) const = default;
};

}  // namespace rayscope::viewer
