#pragma once
#include <rayscope/scene.h>

#include "scene/textures.h"

namespace rayscope::scene {

/// The mesh of an OBJ file, and the materials of its slots.
struct ObjMesh {
    std::shared_ptr<const MeshData> data;
    std::vector<Material> materials;
};

/// Reads an OBJ file and the MTL files and images that it refers to. The vertices of the mesh are the
/// distinct triples of position, texture coordinate and normal; polygons are triangulated. Throws InputError,
/// with the line, at invalid numbers and indices, and if there is no face. Missing MTL files and images and
/// ignored statements are appended to `notes`.
ObjMesh readObj(const std::string& path, TextureCache& textures, Diagnostics& notes);

}  // namespace rayscope::scene
