#pragma once
#include <rayscope/scene.h>

namespace rayscope::scene {

/// The range in which hits are proven correct for every scene (docs/numerics.md): sizes between these, and a
/// centre within kMaxRelativeDistance sizes of the origin.
inline constexpr double kMinSceneSize = 0x1p-60, kMaxSceneSize = 0x1p60, kMaxRelativeDistance = 1e6;

/// Warnings about sizes and positions beyond that range, coordinates that overflow, and shapes too small for
/// the float resolution at their position. Throws Stopped.
Diagnostics lintRange(const SceneDescription& scene, const LoadControl& control = {});

}  // namespace rayscope::scene
