#pragma once
#include "scene/mesh_files/imported_mesh.h"
#include "scene/mesh_files/obj_parser.h"

namespace rayscope::scene {

/// Reads the MTL files that an OBJ file names and returns the materials of its slots. Missing files and
/// undefined materials are warnings in `context.notes`; default materials take their place.
std::vector<Material> readObjMaterials(const std::string& path, const ParsedObj& obj,
                                       const ImportContext& context);

}  // namespace rayscope::scene
