#pragma once
#include <rayscope/scene.h>

namespace rayscope::scene {

/// Warnings about a scene without lights or without geometry.
Diagnostics missingContent(const SceneDescription& scene);

}  // namespace rayscope::scene
