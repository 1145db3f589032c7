#pragma once
#include <rayscope/scene.h>

namespace rayscope::scene {

/// The range in which hits are proven right whatever the scene: sizes between these, and a centre at most so
/// many sizes away from the origin (docs/numerics.md).
inline constexpr double kMinSceneSize = 0x1p-60, kMaxSceneSize = 0x1p60, kMaxRelativeDistance = 1e6;

/// What lies outside the range of numbers that a scene should keep to, in words: sizes and places beyond the
/// proven ones, coordinates that overflow, and shapes so small for their place that float cannot hold them.
Diagnostics lintRange(const SceneDescription& scene);

}  // namespace rayscope::scene
