#pragma once
// What the benchmarks trace: a bumpy sphere of any number of triangles, and four kinds of rays on it.
#include <rayscope/accel.h>
#include <vector>

namespace rayscope::bench {

struct BumpySphere {
    explicit BumpySphere(int triangles);
    AccelInput input() const { return {vertices, triangles, {}}; }

    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

enum class RayKind { Primary, Shadow, Bounce, AmbientOcclusion };
inline constexpr RayKind kRayKinds[] = {RayKind::Primary, RayKind::Shadow, RayKind::Bounce,
                                        RayKind::AmbientOcclusion};
const char* nameOf(RayKind kind);

/// Primary rays in tiles of 8 × 8 pixels; the other kinds start where these hit.
std::vector<Ray> makeRays(const Accel& accel, RayKind kind, int resolution);

}  // namespace rayscope::bench
