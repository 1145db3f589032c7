#pragma once
#include <rayscope/scene.h>

#include "scene/textures.h"

namespace rayscope::scene {

/// What an OBJ file holds: one mesh, and the materials of its slots.
struct ObjMesh {
    std::shared_ptr<const MeshData> data;
    std::vector<Material> materials;
};

/// Reads an OBJ file and the MTL files and images that it names. Vertices are the distinct (position, texture
/// coordinate, normal) corners; polygons are cut into triangles. Throws InputError with the line if an index
/// is out of range or nothing can be seen; what is missing beside it or ignored goes to `notes`.
ObjMesh readObj(const std::string& path, TextureCache& textures, Diagnostics& notes);

}  // namespace rayscope::scene
