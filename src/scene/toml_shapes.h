#pragma once
#include <rayscope/scene.h>

#include "scene/toml_values.h"

namespace rayscope::scene {

/// Reads { shape = "box", … } and makes the mesh.
MeshData readShape(const TomlValue& value);

}  // namespace rayscope::scene
