#pragma once
#include <vector>

#include "scene/mesh_files/gltf/accessor_reader.h"
#include "scene/mesh_files/gltf/scene_graph.h"

namespace rayscope::scene {

/// The matrices that place the mesh of a node: one, or one per instance of EXT_mesh_gpu_instancing. Throws
/// InputError if an accessor is invalid.
std::vector<glm::dmat4> instanceMatrices(const GltfDocument& document, const GltfPlacement& placement,
                                         GltfAccessorReader& accessors);

/// From the coordinates of a skinned mesh to the scene, per joint: the transform of the joint after the
/// inverse of its bind pose. `toScene`: per node.
std::vector<glm::dmat4> jointMatrices(const GltfSkin& skin, const std::vector<glm::dmat4>& toScene,
                                      GltfAccessorReader& accessors);

}  // namespace rayscope::scene
