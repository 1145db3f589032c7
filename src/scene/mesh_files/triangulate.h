#pragma once
#include <rayscope/vector.h>

#include <span>

namespace rayscope::scene {

/// Triangulates a convex or concave polygon of n points by ear clipping. `triangles` has n − 2 elements and
/// receives indices into `points`. The polygon may be slightly non-planar. Polygons without a triangulation
/// (self-intersecting, zero area, non-finite) become a fan.
void triangulate(std::span<const glm::vec3> points, std::span<glm::uvec3> triangles);

}  // namespace rayscope::scene
