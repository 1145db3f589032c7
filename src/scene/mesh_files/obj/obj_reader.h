#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Reads an OBJ file and the MTL files and images that it refers to. The vertices of the mesh are the
/// distinct triples of position, texture coordinate and normal; polygons are triangulated; colours of
/// vertices are decoded from sRGB. Throws InputError, with line and column, at invalid numbers and positions
/// that do not exist, and if there is no face; and Stopped. Whatever else is odd or left out is appended to
/// `context.notes`, once per kind.
ImportedMesh readObj(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
