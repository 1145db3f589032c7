#pragma once
#include <rayscope/vector.h>

#include <functional>
#include <span>
#include <string_view>

namespace rayscope::scene {

/// The warning about polygons of which triangulate() returns false.
inline constexpr std::string_view kCrossingOutline =
    "faces whose outline crosses itself; their triangles overlap";

/// Triangulates a convex or concave polygon of n points by ear clipping. `triangles` has n − 2 elements and
/// receives indices into `points`. The polygon may be slightly non-planar, touch itself, and have holes that
/// bridges of two equal edges connect with its outline. Convex polygons become fans around their first point.
/// Returns false if the outline crosses itself: then the triangles still use every point, but overlap.
/// Polygons of zero area and non-finite ones become fans. Takes O(n log n) for usual outlines. `progress` is
/// called now and then with the number of triangles so far, and may throw.
bool triangulate(std::span<const glm::vec3> points, std::span<glm::uvec3> triangles,
                 const std::function<void(std::size_t)>& progress = {});

}  // namespace rayscope::scene
