#pragma once
#include "scene/mesh_files/imported_mesh.h"

namespace rayscope::scene {

/// Reads an OBJ file and the MTL files and images that it refers to. The vertices of the mesh are the
/// distinct triples of position, texture coordinate and normal; polygons are triangulated. Throws InputError,
/// with the line, at invalid numbers and indices, and if there is no face. Missing MTL files and images and
/// ignored statements are appended to `context.notes`.
ImportedMesh readObj(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
