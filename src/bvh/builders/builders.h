#pragma once
// The builders. Three fill the skeleton for a range of primitives; the fourth optimises a finished tree.
#include <span>

#include "bvh/bounds.h"
#include "bvh/builders/tree_skeleton.h"
#include "bvh/layout/statistics.h"

namespace rayscope::bvh {

/// The bounds of a range of primitives and of their centroids.
struct RangeBounds {
    Bounds4 box;
    Bounds4 centroids;

    void extend(const PrimitiveRef& ref) {
        box.extend(ref.bounds());
        centroids.extend(ref.centroid());
    }
};
RangeBounds boundsOf(std::span<const PrimitiveRef> refs, const std::stop_token& stop);

/// Costs of the surface area heuristic, times the area of the root's box. `children` is the sum over both
/// children of their area times the number of their primitives.
inline float leafCost(float area, std::size_t size) {
    return static_cast<float>(kIntersectionCost) * area * static_cast<float>(size);
}
inline float splitCost(float area, float children) {
    return static_cast<float>(kTraversalCost) * area + static_cast<float>(kIntersectionCost) * children;
}

/// Moves the half with the smaller centroids (of equal ones, the smaller numbers) to the front; returns its
/// size.
std::size_t splitAtMedian(std::span<PrimitiveRef> refs, int axis, const std::stop_token& stop);

/// Object median: splits at the median centroid; the axis is the level modulo 3.
void buildMedian(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs);

/// Surface area heuristic over all centroids of all axes: sorts once per axis and partitions stably.
/// Builds `tree` over refs, which are the primitives of its slots.
void buildSweep(TreeSkeleton& skeleton, std::span<const PrimitiveRef> refs, const Subtree& tree, float scale);

/// Surface area heuristic over the borders of equally wide bins between the centroids; ranges with no more
/// primitives than bins are swept. Up to `maxUnsplit` primitives become a leaf at any cost.
void buildBinned(TreeSkeleton& skeleton, std::span<PrimitiveRef> refs, float scale, std::size_t maxUnsplit);

/// Moves subtrees to reduce the areas of inner nodes, in rounds: the best reinsertion of every node is
/// computed in parallel, then they are applied in order of gain (Meister, Bittner 2018). The result has
/// leaves of up to settings.leafSize primitives and costs no more than `source` with such leaves; `source`
/// should have leaves of one primitive and must not be empty.
BinaryTree improveByReinsertion(const BinaryTree& source, const BuildSettings& settings, float scale);

}  // namespace rayscope::bvh
