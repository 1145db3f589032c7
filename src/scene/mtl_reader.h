#pragma once
#include <rayscope/scene.h>

#include "scene/textures.h"

namespace rayscope::scene {

/// Reads the materials of an MTL file and opens their Kd textures. Unreadable images leave the colour and a
/// warning; what has no meaning here is named once per file in a note. Throws InputError if the file cannot
/// be read.
std::vector<Material> readMtl(const std::string& path, TextureCache& textures, Diagnostics& notes);

}  // namespace rayscope::scene
