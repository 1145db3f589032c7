#pragma once
// What the tracer looked up where a ray met a surface or the environment, laid open.
#include <rayscope/probe.h>
#include <optional>

#include "shading/environment_lookup.h"
#include "shading/texture_lookup.h"

namespace rayscope::probe {

/// The vertices of the triangle that a ray met and their normals, in world space at the time of the ray.
struct VertexNormals {
    glm::vec3 position[3], normal[3];
    double weight[3];  ///< barycentric, of the point that was hit
};
/// Nothing for spheres, misses and meshes without normals.
std::optional<VertexNormals> vertexNormalsOf(const trace::World& world, const RayNode& node, float time);

/// The two by two texels around the point that was hit, in the finest level of the texture.
struct TexelQuad {
    int width = 0, height = 0;  ///< of the texture
    glm::vec2 uv{0.0f};
    int x[2], y[2];       ///< columns and rows, row 0 is the top
    Rgb color[2][2];      ///< [row][column]
    double weight[2][2];  ///< as the filter has them; they sum to 1
    Rgb result{0.0f};     ///< the weighted sum
};
/// Nothing where no texture was looked up. The mipmap filter may read coarser levels beside these texels.
std::optional<TexelQuad> texelsOf(const trace::World& world, const RayNode& node);

/// Where a direction meets the environment map.
struct EnvironmentPoint {
    glm::dvec3 direction{0.0};
    int face = -1;            ///< +x −x +y −y +z −z; -1 for an equirectangular image
    double s = 0.0, t = 0.0;  ///< on the face, from its upper left corner; or longitude, latitude in degrees
    Rgb color{0.0f};
};
/// For a ray that missed; and, with the reflection map, for one that hit: along its reflection.
std::optional<EnvironmentPoint> environmentOf(const trace::World& world, const RayNode& node);
const char* faceName(int face);

/// The square through which the rays of a glossy reflection go: it stands at distance 0.3 along the mirrored
/// direction, and reaches one standard deviation of their displacement to each side.
struct GlossySquare {
    glm::vec3 origin{0.0f}, center{0.0f};
    glm::vec3 right{0.0f}, up{0.0f};  ///< half its sides
    int rays = 0, rejected = 0;       ///< of the tree; rejected ones would go below the surface
};
/// The nodes whose surfaces sent glossy rays.
std::vector<int> glossySurfaces(const RayTree& tree);
std::optional<GlossySquare> glossySquareOf(const trace::World& world, const RayTree& tree, int node);

/// The lens of the camera and the planes that it makes sharp.
struct LensReport {
    std::vector<glm::vec3> outline;  ///< corners of the aperture
    glm::vec3 center{0.0f};
    glm::vec3 focus[4];  ///< corners of the picture in the plane of focus
    std::vector<glm::vec3>
        sharpZone[2];  ///< corners of the picture before and behind it; empty without a zone
};
std::optional<LensReport> lensOf(const trace::World& world);

}  // namespace rayscope::probe
