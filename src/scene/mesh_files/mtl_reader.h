#pragma once
#include <rayscope/scene.h>

#include "scene/textures.h"

namespace rayscope::scene {

/// Reads the materials of an MTL file and loads their Kd textures. If an image cannot be read, a warning is
/// appended to `notes` and Kd is used; ignored statements are listed in one note per file. Throws InputError
/// if the file cannot be read.
std::vector<Material> readMtl(const std::string& path, TextureCache& textures, Diagnostics& notes);

}  // namespace rayscope::scene
