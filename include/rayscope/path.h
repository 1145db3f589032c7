#pragma once
// The words in which paths are told.

namespace rayscope {

/// With a scene, settings and a seed this names a sample; its radiance is a pure function of the name.
struct SampleId {
    int x = 0, y = 0;
    int index = 0;
};

enum class RayKind { Camera, Reflection, Glossy, Transparent };
/// What became of a path after a segment. A surface that both reflects and transmits ends as Transmitted.
enum class RayEnd { Missed, Absorbed, Reflected, Transmitted, DepthLimit, BelowSurface, Vanished };
enum class Visibility { Visible, Occluded, Attenuated, FacingAway };

}  // namespace rayscope
