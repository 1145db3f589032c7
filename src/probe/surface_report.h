#pragma once
// Texture, normal, environment and lens lookups of recorded rays, for display.
#include <rayscope/probe.h>
#include <optional>

#include "shading/environment_lookup.h"
#include "shading/texture_lookup.h"

namespace rayscope::probe {

/// The vertices of the triangle that a ray hit and their normals, in world space at the time of the ray.
struct VertexNormals {
    glm::vec3 position[3], normal[3];
    double weight[3];  ///< barycentric, of the hit
};
/// Nothing for spheres, misses and meshes without normals.
std::optional<VertexNormals> vertexNormalsOf(const trace::World& world, const RayNode& node, float time);

/// The 2 × 2 texels around the hit, in the finest level of the texture.
struct TexelQuad {
    int width = 0, height = 0;  ///< of the texture
    glm::vec2 uv{0.0f};
    int x[2], y[2];       ///< columns and rows, row 0 is the top
    Rgb color[2][2];      ///< [row][column]
    double weight[2][2];  ///< of the texture filter; their sum is 1
    Rgb result{0.0f};     ///< the weighted sum
};
/// Nothing without a texture lookup. The mipmap filter may also read coarser levels.
std::optional<TexelQuad> texelsOf(const trace::World& world, const RayNode& node);

/// An environment map lookup.
struct EnvironmentPoint {
    glm::dvec3 direction{0.0};
    int face = -1;            ///< +x −x +y −y +z −z; -1 for an equirectangular image
    double s = 0.0, t = 0.0;  ///< on the face, from its upper left corner; or longitude, latitude in degrees
    Rgb color{0.0f};
};
/// For a ray that missed; and, with the reflection map, for one that hit: along its reflection.
std::optional<EnvironmentPoint> environmentOf(const trace::World& world, const RayNode& node);
const char* faceName(int face);

/// The square that shows the spread of a glossy reflection: at distance 0.3 along the mirrored direction,
/// with half sides of one standard deviation of the displacement.
struct GlossySquare {
    glm::vec3 origin{0.0f}, center{0.0f};
    glm::vec3 right{0.0f}, up{0.0f};  ///< half its sides
    int rays = 0, rejected = 0;       ///< of the tree; rejected ones point below the surface
};
/// The nodes with glossy reflection rays.
std::vector<int> glossySurfaces(const RayTree& tree);
std::optional<GlossySquare> glossySquareOf(const trace::World& world, const RayTree& tree, int node);

/// The aperture of the camera and its focal plane.
struct LensReport {
    std::vector<glm::vec3> outline;  ///< corners of the aperture
    glm::vec3 center{0.0f};
    glm::vec3 focus[4];  ///< corners of the image in the focal plane
    /// Corners of the image at the near and far end of the sharp zone; empty without one.
    std::vector<glm::vec3> sharpZone[2];
};
std::optional<LensReport> lensOf(const trace::World& world);

}  // namespace rayscope::probe
