#include "probe/surface_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/frame.h"
#include "trace/world.h"

namespace rayscope::probe {

namespace {

/// The viewing direction mirrored at the shading normal, or, if that points below the surface, at the
/// geometric normal, as in the tracer.
glm::dvec3 mirroredDirection(const RayNode& node) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(node.ray.direction));
    const auto mirrored = [&](const glm::dvec3& n) { return d - 2.0 * glm::dot(d, n) * n; };
    const glm::dvec3 byShading = mirrored(glm::dvec3(node.normal));
    const bool above = glm::dot(byShading, glm::dvec3(node.geometricNormal)) > 0.0;
    return glm::normalize(above ? byShading : mirrored(glm::dvec3(node.geometricNormal)));
}

std::vector<glm::dvec2> apertureOutline(LensShape shape) {
    const int corners = shape == LensShape::Square ? 4 : shape == LensShape::Hexagon ? 6 : 48;
    // The side of the square is the diameter of the disk.
    const double radius = shape == LensShape::Square ? std::numbers::sqrt2 : 1.0;
    const double start = shape == LensShape::Square ? std::numbers::pi / 4.0 : 0.0;
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = start + 2.0 * std::numbers::pi * i / corners;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

}  // namespace

std::optional<VertexNormals> vertexNormalsOf(const trace::World& world, const RayNode& node, float time) {
    if (!node.hit) return std::nullopt;
    const trace::PrimitiveLocation name = world.locatePrimitive(node.primitiveHit.primitive);
    if (name.range->mesh == nullptr || name.range->mesh->normals.empty()) return std::nullopt;
    const trace::Geometry& geometry = *name.motionGroup->geometry;
    const glm::uvec3 corner = geometry.input.triangles[name.inGroup];
    const glm::uvec3 index = name.range->mesh->triangles[name.inObject];
    VertexNormals result;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 n(name.range->mesh->normals[index[i]]);
        if (name.range->transformed) n = name.range->normalMatrix * n;
        const double length = glm::length(n);
        result.normal[i] = glm::vec3(length > 0.0 ? n / length : n);
        result.position[i] = geometry.input.vertices[corner[i]] + time * geometry.motion;
    }
    const Hit& hit = node.primitiveHit;
    result.weight[0] = 1.0 - static_cast<double>(hit.u) - static_cast<double>(hit.v);
    result.weight[1] = static_cast<double>(hit.u);
    result.weight[2] = static_cast<double>(hit.v);
    return result;
}

std::optional<TexelQuad> texelsOf(const trace::World& world, const RayNode& node) {
    if (!node.hit) return std::nullopt;
    const shading::MipTexture* texture = world.materials[static_cast<std::size_t>(node.material)].texture;
    const trace::PrimitiveLocation name = world.locatePrimitive(node.primitiveHit.primitive);
    if (texture == nullptr || (name.range->mesh != nullptr && name.range->mesh->texCoords.empty()))
        return std::nullopt;
    const RgbImage& image = texture->source()->image;
    const shading::BilinearTap tap =
        shading::bilinearTap(image.width, image.height, glm::dvec2(node.uv), texture->source()->wrap);
    TexelQuad quad;
    quad.width = image.width;
    quad.height = image.height;
    quad.uv = node.uv;
    const double columns[] = {1.0 - tap.weightX, tap.weightX}, rows[] = {1.0 - tap.weightY, tap.weightY};
    const bool nearest = world.settings.textureFilter == TextureFilter::Nearest;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            quad.x[column] = tap.x[column];
            quad.y[row] = tap.y[row];
            quad.color[row][column] = image.at(tap.x[column], tap.y[row]);
            quad.weight[row][column] = columns[column] * rows[row];
            if (nearest)
                quad.weight[row][column] =
                    (column == (tap.weightX >= 0.5 ? 1 : 0)) && (row == (tap.weightY >= 0.5 ? 1 : 0)) ? 1.0
                                                                                                      : 0.0;
            quad.result += static_cast<float>(quad.weight[row][column]) * quad.color[row][column];
        }
    return quad;
}

std::optional<EnvironmentPoint> environmentOf(const trace::World& world, const RayNode& node) {
    if (!world.environment || (node.hit && !world.settings.reflectionMap)) return std::nullopt;
    if (!node.hit && node.end != RayEnd::Missed) return std::nullopt;
    EnvironmentPoint point;
    point.direction = node.hit ? mirroredDirection(node) : glm::dvec3(node.ray.direction);
    point.color = Rgb(shading::lookup(*world.environment, point.direction));
    if (world.environment->equirect) {
        const glm::dvec3& d = point.direction;
        point.s = glm::degrees(std::atan2(d.x, -d.z));
        point.t = glm::degrees(std::atan2(d.y, std::hypot(d.x, d.z)));
    } else {
        const shading::CubePoint onCube = shading::cubePoint(point.direction);
        point.face = onCube.face;
        point.s = onCube.s;
        point.t = onCube.t;
    }
    return point;
}

const char* faceName(int face) {
    constexpr const char* kNames[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
    return face >= 0 && face < 6 ? kNames[face] : "whole";
}

std::vector<int> glossySurfaces(const RayTree& tree) {
    std::vector<int> surfaces;
    for (const RayNode& node : tree.nodes)
        if (node.kind == RayKind::Glossy && (surfaces.empty() || surfaces.back() != node.parent) &&
            std::find(surfaces.begin(), surfaces.end(), node.parent) == surfaces.end())
            surfaces.push_back(node.parent);
    return surfaces;
}

std::optional<GlossySquare> glossySquareOf(const trace::World& world, const RayTree& tree, int number) {
    const RayNode& node = tree.nodes[static_cast<std::size_t>(number)];
    GlossySquare square;
    for (const RayNode& child : tree.nodes) {
        if (child.parent != number || child.kind != RayKind::Glossy) continue;
        square.origin = child.ray.origin;
        ++square.rays;
        square.rejected += child.end == RayEnd::BelowSurface ? 1 : 0;
    }
    if (square.rays == 0) return std::nullopt;
    const glm::dvec3 direction = mirroredDirection(node);
    const math::Frame frame = math::frameAround(direction);
    const double shininess =
        std::max(world.materials[static_cast<std::size_t>(node.material)].shininess, 1e-6);
    const double deviation = static_cast<double>(world.settings.glossySigma) / (3.0 * shininess);
    square.center = square.origin + glm::vec3(0.3 * direction);
    square.right = glm::vec3(deviation * frame.u);
    square.up = glm::vec3(deviation * frame.v);
    return square;
}

std::optional<LensReport> lensOf(const trace::World& world) {
    const trace::Camera& camera = world.camera;
    if (!camera.hasLens()) return std::nullopt;
    LensReport lens;
    const glm::dvec2 size(world.width, world.height);
    for (const glm::dvec2& point : apertureOutline(world.settings.lensShape))
        lens.outline.push_back(camera.lensRay(0.5 * size, point).origin);
    lens.center = camera.pinholeRay(0.5 * size).origin;
    const glm::dvec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto atDepth = [&](const glm::dvec2& corner, double depth) {
        const Ray ray = camera.pinholeRay(corner * size);
        const glm::dvec3 origin(ray.origin), direction(ray.direction);
        return glm::vec3(origin + direction * (depth / camera.depthOf(origin + direction)));
    };
    const double zone = static_cast<double>(world.settings.sharpZone);
    for (int i = 0; i < 4; ++i) {
        lens.focus[i] = atDepth(corners[i], camera.focusDistance());
        if (!(zone > 0.0)) continue;
        lens.sharpZone[0].push_back(atDepth(corners[i], std::max(0.0, camera.focusDistance() - zone)));
        lens.sharpZone[1].push_back(atDepth(corners[i], camera.focusDistance() + zone));
    }
    return lens;
}

}  // namespace rayscope::probe
