#pragma once
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <string_view>
#include <vector>

namespace rayscope::measure {

/// The kinds of rays that benchmarks of ray tracers ask for.
enum class BenchRayKind {
    Primary,          ///< from the camera, in tiles of 8 × 8 pixels
    Shadow,           ///< from what these hit to one point light
    Bounce,           ///< from there, cosine-distributed, as far as they go
    AmbientOcclusion  ///< the same, up to a tenth of the size of the scene
};
inline constexpr BenchRayKind kBenchRayKinds[] = {BenchRayKind::Primary, BenchRayKind::Shadow,
                                                  BenchRayKind::Bounce, BenchRayKind::AmbientOcclusion};
std::string_view benchNameOf(BenchRayKind kind);

/// Whether the kind asks only if anything is in the way.
bool isAnyHitKind(BenchRayKind kind);

/// The same rays for the same arguments. `size` × `size` pixels; the other kinds start where the primary rays
/// hit, moved towards the viewer by 10^-5 of the size of the scene.
std::vector<Ray> makeBenchRays(const Accel& accel, const CameraDescription& camera, const glm::vec3& light,
                               BenchRayKind kind, int size);

}  // namespace rayscope::measure
