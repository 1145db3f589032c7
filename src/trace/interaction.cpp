#include "trace/interaction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bvh/intersect/intersect_sphere.h"
#include "bvh/intersect/intersect_triangle.h"
#include "math/spawn.h"
#include "math/vectors.h"
#include "shading/sphere_texture.h"

namespace rayscope::trace {

namespace {

/// For vectors computed from floats by sums and at most one product, whose squares neither overflow nor
/// underflow in double. Zero stays zero; non-finite vectors become zero.
glm::dvec3 normalizeOfFloats(const glm::dvec3& v) {
    const double square = glm::dot(v, v);
    return square > 0.0 && square < std::numeric_limits<double>::infinity() ? v * (1.0 / std::sqrt(square))
                                                                            : glm::dvec3(0.0);
}

/// Scales before it normalises, so that squares neither overflow nor underflow. Zero stays zero; non-finite
/// vectors become zero.
glm::dvec3 safeNormalize(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) return glm::dvec3(0.0);
    return glm::normalize(v / largest);
}

struct Triangle {
    glm::uvec3 index;  ///< of the vertices, within the mesh
    glm::dvec3 p[3];   ///< in the rest frame
};

Triangle triangleOf(const PrimitiveLocation& location) {
    const AccelInput& input = location.motionGroup->geometry->input;
    const glm::uvec3 inGroup = input.triangles[location.inGroup];
    return {location.range->mesh->triangles[location.inObject],
            {glm::dvec3(input.vertices[inGroup.x]), glm::dvec3(input.vertices[inGroup.y]),
             glm::dvec3(input.vertices[inGroup.z])}};
}

/// Interpolates vertex normals; keeps the geometric normal if the sum vanishes or is not finite.
void interpolateNormal(Interaction& at, const PrimitiveLocation& location, const Triangle& triangle,
                       const glm::dvec3& weights) {
    const std::vector<glm::vec3>& normals = location.range->mesh->normals;
    if (normals.empty()) return;
    glm::dvec3 sum(0.0);
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 n(normals[triangle.index[i]]);
        if (location.range->transformed) n = safeNormalize(location.range->normalMatrix * n);
        sum += weights[i] * n;
        largest = std::max(largest, glm::dot(n, n));
    }
    // Opposite normals cancel to rounding noise, whose direction is meaningless.
    if (!math::isFinite(sum) || !(glm::dot(sum, sum) > 1e-12 * largest)) return;
    at.normal = safeNormalize(sum);
    at.interpolated = true;
}

/// Area in texture space per area of the surface, that is, the square of uv per unit of length.
double textureDensity(const Triangle& triangle, const std::vector<glm::vec2>& uv) {
    const glm::dvec2 a(uv[triangle.index.x]), b(uv[triangle.index.y]), c(uv[triangle.index.z]);
    const double inTexture = std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    const double onSurface =
        glm::length(glm::cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]));
    return onSurface > 0.0 ? inTexture / onSurface : 0.0;
}

/// Replaces kd by the texture at at.uv. `density` computes the area in texture space per area of the surface.
template <class Density>
void lookUpTexture(Interaction& at, const World& world, const Density& density) {
    double footprint = 0.0;
    if (world.settings.textureFilter == TextureFilter::Mipmap) {
        // The cone's footprint on the surface is an ellipse; its long axis, larger by the inverse cosine,
        // is used to avoid aliasing.
        const double cosine = std::abs(glm::dot(at.geometricNormal, at.toViewer));
        footprint = at.coneWidth / std::max(cosine, 1e-9) * std::sqrt(density());
    }
    at.kd = world.materials[at.material].texture->lookup(at.uv, footprint, world.settings.textureFilter);
}

void textureTriangle(Interaction& at, const World& world, const PrimitiveLocation& location,
                     const Triangle& triangle, const glm::dvec3& weights) {
    const std::vector<glm::vec2>& uv = location.range->mesh->texCoords;
    if (!world.materials[at.material].texture || uv.empty()) return;
    glm::dvec2 sum(0.0);
    for (int i = 0; i < 3; ++i) sum += weights[i] * glm::dvec2(uv[triangle.index[i]]);
    at.uv = glm::vec2(sum);
    lookUpTexture(at, world, [&] { return textureDensity(triangle, uv); });
}

/// `outward` is the unit normal at the hit.
void textureSphere(Interaction& at, const World& world, const glm::dvec3& outward, double radius) {
    if (!world.materials[at.material].texture) return;
    at.uv = glm::vec2(shading::sphereTexCoords(outward));
    lookUpTexture(at, world, [&] {
        // du dv = dφ / 2π · dθ / π, and the area is r² cos θ dφ dθ at the latitude θ.
        const double ring = std::max(std::hypot(outward.x, outward.z), 1e-9);
        return 1.0 / (2.0 * std::numbers::pi * std::numbers::pi * radius * radius * ring);
    });
}

/// Replaces kd by the interpolated vertex colour, or multiplies the texel by it.
void showVertexColors(Interaction& at, const World& world, const PrimitiveLocation& location,
                      const glm::uvec3& index, const glm::dvec3& weights) {
    const std::vector<Rgb>& colors = *location.range->colors;
    const glm::dvec3 color = weights.x * glm::dvec3(colors[index.x]) +
                             weights.y * glm::dvec3(colors[index.y]) +
                             weights.z * glm::dvec3(colors[index.z]);
    const bool isTextured = world.materials[at.material].texture && !location.range->mesh->texCoords.empty();
    at.kd = isTextured ? at.kd * color : color;
}

void fillTriangle(Interaction& at, const World& world, const Ray& ray, const PrimitiveLocation& location) {
    const AccelInput& input = location.motionGroup->geometry->input;
    const Triangle triangle = triangleOf(location);
    const glm::uvec3 index = input.triangles[location.inGroup];
    bvh::TriangleHit exact{static_cast<double>(at.hit.t), static_cast<double>(at.hit.u),
                           static_cast<double>(at.hit.v)};
    bvh::intersectTriangle(bvh::ShearedRay(bvh::rayData(ray)), input.vertices[index.x],
                           input.vertices[index.y], input.vertices[index.z], exact);
    const glm::dvec3 weights(1.0 - exact.u - exact.v, exact.u, exact.v);
    at.t = exact.t;
    at.position = weights.x * triangle.p[0] + weights.y * triangle.p[1] + weights.z * triangle.p[2];
    at.magnitude =
        glm::max(glm::max(glm::abs(triangle.p[0]), glm::abs(triangle.p[1])), glm::abs(triangle.p[2]));
    at.geometricNormal =
        normalizeOfFloats(glm::cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]));
    at.normal = at.geometricNormal;
    if (world.settings.normalInterpolation) interpolateNormal(at, location, triangle, weights);
    textureTriangle(at, world, location, triangle, weights);
    if (location.range->colors) showVertexColors(at, world, location, triangle.index, weights);
}

void fillSphere(Interaction& at, const World& world, const Ray& ray, const Sphere& sphere) {
    double t = static_cast<double>(at.hit.t);
    bvh::intersectSphere(ray, sphere, ray.tMin, ray.tMax, t);
    const glm::dvec3 center(sphere.center);
    const double radius = static_cast<double>(sphere.radius);
    const glm::dvec3 fromCenter =
        safeNormalize(glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction) - center);
    at.t = t;
    at.position = center + radius * fromCenter;
    at.magnitude = glm::abs(center) + radius;
    at.geometricNormal = at.normal = fromCenter;
    textureSphere(at, world, fromCenter, radius);
}

/// Turns the geometric normal to the viewer's side and the shading normal to the side of the geometric one.
void faceViewer(Interaction& at) {
    if (glm::dot(at.geometricNormal, at.toViewer) < 0.0) at.geometricNormal = -at.geometricNormal;
    if (glm::dot(at.normal, at.geometricNormal) < 0.0) at.normal = -at.normal;
}

}  // namespace

glm::vec3 Interaction::originOutside() const {
    return math::spawnOrigin(position, magnitude, geometricNormal);
}
glm::vec3 Interaction::originBehind() const {
    return math::spawnOrigin(position, magnitude, -geometricNormal);
}

Interaction interactionAt(const World& world, const Ray& ray, float time, const RayCone& cone,
                          const Hit& hit) {
    Interaction at;
    at.hit = hit;
    const PrimitiveLocation location = world.locatePrimitive(hit.primitive);
    at.object = location.range->object;
    at.material = world.materialOf(location);
    at.kd = world.materials[at.material].kd;
    const glm::dvec3 direction(ray.direction);
    const double length = glm::length(direction);
    at.toViewer = -direction / length;
    at.coneWidth = cone.width + cone.spread * static_cast<double>(hit.t) * length;

    const Geometry& geometry = *location.motionGroup->geometry;
    const Ray atRest = world.moves ? geometry.inRestFrame(ray, time) : ray;
    if (location.range->mesh)
        fillTriangle(at, world, atRest, location);
    else
        fillSphere(at, world, atRest,
                   geometry.input.spheres[location.inGroup - geometry.input.triangles.size()]);
    if (world.moves) {
        const glm::dvec3 moved = geometry.displacement(time);
        at.position += moved;
        at.magnitude += glm::abs(moved);
        // The transform of the ray's origin into the rest frame rounds to float, which is an error of the
        // position.
        at.magnitude += 0x1p20 * (glm::abs(glm::dvec3(ray.origin)) + glm::abs(moved));
    }
    faceViewer(at);
    return at;
}

}  // namespace rayscope::trace
