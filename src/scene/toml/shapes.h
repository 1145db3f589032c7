#pragma once
#include <rayscope/scene.h>

#include "scene/toml/values.h"

namespace rayscope::scene {

/// Generates the mesh of { shape = "box", … }. Throws InputError.
MeshData readShape(const TomlValue& value);

}  // namespace rayscope::scene
