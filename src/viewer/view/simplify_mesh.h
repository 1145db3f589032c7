#pragma once
#include <rayscope/scene.h>
#include <stop_token>

namespace rayscope::viewer {

/// A mesh of at most about `maxTriangles` triangles that looks much like `mesh` from afar, to be drawn while
/// the camera moves; never more triangles than the mesh has. Vertices in the same cell of a grid become one,
/// at their mean (Rossignac and Borrel 1993), and triangles that lose a corner go; the cells are as small as
/// the number of triangles allows. Of a mesh that would vanish this way, because its triangles hardly touch
/// one another, an even choice of triangles is taken as it is. Throws Stopped when asked to stop.
MeshData simplifyMesh(const MeshData& mesh, std::size_t maxTriangles, std::stop_token stop = {});

}  // namespace rayscope::viewer
