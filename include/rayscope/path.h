#pragma once
// Vocabulary types of ray paths.

namespace rayscope {

/// Identifies a sample, given scene, settings and seed; its radiance is a pure function of all of these.
struct SampleId {
    int x = 0, y = 0;
    int index = 0;
};

enum class RayKind { Camera, Reflection, Glossy, Transparent };
/// How a path continues or ends after a segment. A surface that both reflects and transmits counts as
/// Transmitted.
enum class RayEnd { Missed, Absorbed, Reflected, Transmitted, DepthLimit, BelowSurface, Vanished };
enum class Visibility { Visible, Occluded, Attenuated, FacingAway };

}  // namespace rayscope
