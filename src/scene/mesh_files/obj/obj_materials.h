#pragma once
#include "scene/imported_mesh.h"
#include "scene/mesh_files/obj/obj_parser.h"

namespace rayscope::scene {

/// Reads the MTL files that an OBJ file names and returns the materials of its slots. Missing files and
/// undefined materials are warnings in `context.notes`; default materials take their place.
std::vector<Material> readObjMaterials(const std::string& path, const ParsedObj& obj,
                                       const ImportContext& context);

}  // namespace rayscope::scene
