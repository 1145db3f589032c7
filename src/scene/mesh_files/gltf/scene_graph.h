#pragma once
#include <string>
#include <vector>

#include "scene/mesh_files/gltf/document.h"

namespace rayscope::scene {

/// Something that a node places in the scene: `index` into the meshes, cameras or lights of the document.
struct GltfPlacement {
    std::uint32_t index = 0, node = 0;
    glm::dmat4 toScene{1.0};  ///< from the coordinates of the node
};

struct GltfPlacements {
    std::vector<GltfPlacement> meshes{}, cameras{}, lights{};
    std::vector<glm::dmat4> toScene{};  ///< per node of the document; the identity for those beyond the scene
};

/// What the nodes of the scene place, in the order of the nodes. Throws InputError if a node is its own
/// ancestor. A node that is reached twice counts once, with a warning.
GltfPlacements placementsOf(const GltfDocument& document, const std::string& path, Oddities& oddities);

}  // namespace rayscope::scene
