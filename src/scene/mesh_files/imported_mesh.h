#pragma once
#include <rayscope/scene.h>

#include "scene/textures.h"

namespace rayscope::scene {

/// The content of a mesh file: one mesh, and the materials of its slots. Formats that store cameras and
/// lights add those; they are used when the file is opened by itself.
struct ImportedMesh {
    std::shared_ptr<const MeshData> data{};
    std::vector<Material> materials{};
    std::vector<CameraDescription> cameras{};
    std::vector<Light> lights{};
};

/// What the readers of mesh files share during one loadScene().
struct ImportContext {
    TextureCache& textures;
    Diagnostics& notes;
    const LoadControl& control;
};

}  // namespace rayscope::scene
