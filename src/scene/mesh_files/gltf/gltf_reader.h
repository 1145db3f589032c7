#pragma once
#include "scene/imported_mesh.h"

namespace rayscope::scene {

/// Reads a glTF 2.0 file, as JSON or GLB, with its buffers and images: the triangles of all nodes of the
/// scene in one mesh, the materials that they use, perspective cameras, point and directional lights. Throws
/// InputError, with the line if the JSON is damaged, else with the place in the document; appends what is
/// approximated or left out to `context.notes`.
ImportedMesh readGltf(const std::string& path, const ImportContext& context);

}  // namespace rayscope::scene
