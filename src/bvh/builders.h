#pragma once
// The three builders. Each fills the skeleton for a range of primitives.
#include <span>

#include "bvh/bounds.h"
#include "bvh/tree_skeleton.h"

namespace rayscope {

/// What the surface area heuristic needs of a range of primitives.
struct RangeBounds {
    Bounds4 box;
    Bounds4 centroids;

    void extend(const PrimitiveRef& ref) {
        box.extend(ref.bounds());
        centroids.extend(ref.centroid());
    }
};
RangeBounds boundsOf(std::span<const PrimitiveRef> refs, const std::stop_token& stop);

/// Object median: halves at the median centroid; the axes take turns with the level.
void buildMedian(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs);

/// Surface area heuristic over all centroids of all axes: sorts once per axis and partitions stably.
/// Builds `tree` over refs, which are the primitives of its slots.
void buildSweep(TreeSkeleton& skeleton, std::span<const PrimitiveRef> refs, const Subtree& tree, float scale);

/// Surface area heuristic over the borders of equally wide bins between the centroids; ranges with no more
/// primitives than bins are swept.
void buildBinned(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs, float scale);

}  // namespace rayscope
