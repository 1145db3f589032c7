#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Reads an STL file, ASCII or binary, as one mesh with a default material. Corners with the same bits share
/// a vertex; normals and colours of facets are ignored. Memory beyond the mesh: 4 to 8 bytes per triangle.
/// Throws InputError, with line and column in ASCII files.
ImportedMesh readStl(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
