#pragma once
#include <rayscope/scene.h>

#include "scene/mesh_files/gltf/scene_graph.h"

namespace rayscope::scene {

/// The perspective cameras, with unique names. `bounds` of the triangles decide how far away lookAt is.
std::vector<CameraDescription> gltfCameras(const GltfDocument& document,
                                           const std::vector<GltfPlacement>& placed,
                                           const SceneBounds& bounds, Oddities& oddities);

/// Point lights of intensity I, in candela, become lights of colour I/π with inverse-square falloff, because
/// kd is a reflectance and the model of the format divides by π. Directional lights of illuminance E, in lux,
/// become distant point lights of colour E/π without falloff.
std::vector<Light> gltfLights(const GltfDocument& document, const std::vector<GltfPlacement>& placed,
                              const SceneBounds& bounds, Oddities& oddities);

}  // namespace rayscope::scene
