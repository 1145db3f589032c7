#pragma once
#include <rayscope/scene.h>

#include <string_view>

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
    bool withColors = false;  ///< vertex colours are shown; otherwise they are not stored
};

/// The note about a file with vertex colours that are not stored.
constexpr std::string_view kColorsNotShown =
    "vertex colours are not shown; vertex_colors = true in [[mesh]] shows them";

}  // namespace rayscope::scene
