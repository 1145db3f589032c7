#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Reads the materials of an MTL file and loads their Kd textures; names are as written, with quotes and
/// comments. What is left out or odd is appended to `context.notes`, once per kind. If an image cannot be
/// read, Kd is used. Throws InputError if the file cannot be read, and Stopped.
std::vector<Material> readMtl(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
