#pragma once
#include <rayscope/ray.h>
#include <rayscope/vector.h>

#include "trace/world.h"

namespace rayscope::trace {

/// The footprint of a ray: a cone whose width grows by `spread` per unit of distance. Used for texture
/// filtering only (Akenine-Möller et al. 2021, "Improved Shader and Texture Level of Detail Using Ray
/// Cones").
struct RayCone {
    double width = 0.0, spread = 0.0;
};

/// The surface at a hit, as shading needs it.
struct Interaction {
    Hit hit;
    double t = 0.0;  ///< distance in units of the ray's direction, in double
    glm::dvec3 position{0.0};
    glm::dvec3 magnitude{0.0};        ///< bound of the coordinates that `position` was computed from
    glm::dvec3 geometricNormal{0.0};  ///< unit, on the viewer's side
    glm::dvec3 normal{0.0};           ///< shading normal, unit, on the viewer's side
    glm::dvec3 toViewer{0.0};         ///< unit
    glm::vec2 uv{0.0f};
    std::uint32_t object = 0, material = 0;
    glm::dvec3 kd{0.0};  ///< diffuse colour of the material, the texture and the vertices
    double coneWidth = 0.0;
    bool interpolated = false;  ///< the shading normal comes from vertex normals

    /// Origins of rays spawned on the viewer's side and on the other side.
    glm::vec3 originOutside() const;
    glm::vec3 originBehind() const;
};

/// Recomputes the hit in double and evaluates normals, texture and vertex colours there. `hit` must be the
/// result of World::closestHit() for this ray and time.
Interaction interactionAt(const World& world, const Ray& ray, float time, const RayCone& cone,
                          const Hit& hit);

}  // namespace rayscope::trace
