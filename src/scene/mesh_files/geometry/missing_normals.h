#pragma once
#include <rayscope/scene.h>

#include <vector>

namespace rayscope::scene {

/// Computes the marked normals of a mesh as the mean of the faces of each vertex, weighted by area. Right for
/// all sizes of floats, since lengths are computed in double precision. A vertex whose faces have no area
/// gets (0, 0, 0).
void computeMissingNormals(const std::vector<bool>& isMissing, MeshData& mesh);

}  // namespace rayscope::scene
