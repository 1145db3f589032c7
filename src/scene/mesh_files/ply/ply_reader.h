#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Reads a PLY file, ASCII or binary: the elements vertex, face and tristrips, and the textures that comments
/// of MeshLab name. Polygons are triangulated. Memory beyond the mesh is bounded, except that texture
/// coordinates per corner of faces need a second copy of the vertices. Throws InputError with the line of the
/// header or of an ASCII file, or the row of a binary one.
ImportedMesh readPly(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
