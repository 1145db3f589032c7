#pragma once
#include <rayscope/vector.h>

#include <span>

namespace rayscope::scene {

/// Cuts a polygon, convex or not, into size − 2 triangles of indices into `points`, by clipping ears. The
/// polygon may be slightly bent; what cannot be cut properly (it crosses itself, has no area or is not
/// finite) becomes a fan. `triangles` has size − 2 elements.
void triangulate(std::span<const glm::vec3> points, std::span<glm::uvec3> triangles);

}  // namespace rayscope::scene
