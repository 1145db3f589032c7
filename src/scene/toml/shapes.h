#pragma once
#include <rayscope/scene.h>

#include <functional>

#include "scene/toml/values.h"

namespace rayscope::scene {

/// Generates a mesh; throws Stopped.
using MeshGenerator = std::function<MeshData(const LoadControl& control)>;

/// The generator of { shape = "box", … }. Throws InputError.
MeshGenerator readShape(const TomlValue& value);

}  // namespace rayscope::scene
