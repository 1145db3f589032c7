#pragma once
#include <rayscope/accel.h>
#include <rayscope/scene.h>
#include <string_view>
#include <vector>

namespace rayscope::measure {

/// The kinds of rays of a benchmark.
enum class BenchRayKind {
    Primary,          ///< from the camera, in tiles of 8 × 8 pixels
    Shadow,           ///< from the hit points of primary rays to a point light
    Bounce,           ///< from the same points, cosine-distributed, unbounded
    AmbientOcclusion  ///< the same, up to a tenth of the size of the scene
};
inline constexpr BenchRayKind kBenchRayKinds[] = {BenchRayKind::Primary, BenchRayKind::Shadow,
                                                  BenchRayKind::Bounce, BenchRayKind::AmbientOcclusion};
std::string_view benchNameOf(BenchRayKind kind);

/// Whether rays of this kind are any-hit queries.
bool isAnyHitKind(BenchRayKind kind);

/// The rays of `size` × `size` pixels, a pure function of the arguments. Kinds other than primary start at
/// the hit points of the primary rays, offset along the normal by 10^-5 of the size of the scene.
std::vector<Ray> makeBenchRays(const Accel& accel, const CameraDescription& camera, const glm::vec3& light,
                               BenchRayKind kind, int size);

}  // namespace rayscope::measure
