#pragma once
#include <rayscope/scene.h>
#include <stop_token>

namespace rayscope::viewer {

/// A mesh of at most about `maxTriangles` triangles that resembles `mesh`, to be drawn while the camera
/// moves; never more triangles than the mesh has. Vertex clustering (Rossignac and Borrel 1993): vertices in
/// the same grid cell are merged at their mean, degenerate triangles are removed; the cells are as small as
/// the number of triangles allows. If little area remains, because the triangles are small and not connected,
/// an even subset of the triangles is returned instead. Throws Stopped on request.
MeshData simplifyMesh(const MeshData& mesh, std::size_t maxTriangles, std::stop_token stop = {});

}  // namespace rayscope::viewer
