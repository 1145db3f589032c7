// Spheres and the torus.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "scene/generate/generate.h"
#include "scene/load_step.h"

namespace rayscope::scene {

namespace {

constexpr double kPi = std::numbers::pi;

/// cos and sin of step i of n around a circle; steps 0 and n are bit-identical.
glm::dvec2 onCircle(int i, int n) {
    const double angle = 2.0 * kPi * (i % n) / n;
    return {std::cos(angle), std::sin(angle)};
}

void addVertex(MeshData& mesh, const glm::dvec3& position, const glm::dvec3& normal, double u, double v) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(glm::normalize(normal));
    mesh.texCoords.emplace_back(u, v);
}

}  // namespace

MeshData generate(const UvSphereShape& shape, const LoadControl& control) {
    MeshData mesh;
    const int columns = shape.segments, rows = shape.rings;
    LoadStep step(control, "generating a sphere", static_cast<std::size_t>(2 * rows + 1));
    const auto radius = static_cast<double>(shape.radius);
    for (int j = 0; j <= rows; ++j) {
        step.advance();
        const bool pole = j == 0 || j == rows;
        const double latitude = kPi * (static_cast<double>(j) / rows - 0.5);
        const double ring = pole ? 0.0 : std::cos(latitude);
        for (int i = 0; i <= columns; ++i) {
            const glm::dvec2 around = onCircle(i, columns);
            const glm::dvec3 normal(ring * around.x, std::sin(latitude), -ring * around.y);
            // A pole has one vertex per triangle, with the texture coordinate at the middle of the triangle.
            addVertex(mesh, radius * normal, normal, (i + (pole ? 0.5 : 0.0)) / columns,
                      static_cast<double>(j) / rows);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j) {
        step.advance();
        for (int i = 0; i < columns; ++i) {
            if (j > 0) mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i, j + 1));
            if (j + 1 < rows) mesh.triangles.emplace_back(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

MeshData generate(const TorusShape& shape, const LoadControl& control) {
    MeshData mesh;
    LoadStep step(control, "generating a torus", static_cast<std::size_t>(2 * shape.tubeSegments + 1));
    for (int j = 0; j <= shape.tubeSegments; ++j) {
        step.advance();
        for (int i = 0; i <= shape.segments; ++i) {
            const glm::dvec2 around = onCircle(i, shape.segments), tube = onCircle(j, shape.tubeSegments);
            const glm::dvec3 normal(tube.x * around.x, tube.y, -tube.x * around.y);
            const glm::dvec3 center =
                static_cast<double>(shape.radius) * glm::dvec3(around.x, 0.0, -around.y);
            addVertex(mesh, center + static_cast<double>(shape.tubeRadius) * normal, normal,
                      static_cast<double>(i) / shape.segments, static_cast<double>(j) / shape.tubeSegments);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (shape.segments + 1) + i); };
    for (int j = 0; j < shape.tubeSegments; ++j) {
        step.advance();
        for (int i = 0; i < shape.segments; ++i) {
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

namespace {

/// The icosahedron in the unit sphere, from three golden rectangles; normals only.
MeshData icosahedron() {
    MeshData mesh;
    const double golden = std::numbers::phi;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {1.0, -1.0})
            for (const double b : {golden, -golden}) {
                glm::dvec3 point(0.0);
                point[axis] = a;
                point[(axis + 1) % 3] = b;
                mesh.normals.emplace_back(glm::normalize(point));
            }
    // Vertices that share an edge have a dot product of 1/√5, others of −1/√5 or −1.
    const auto isEdge = [&](std::uint32_t a, std::uint32_t b) {
        return glm::dot(mesh.normals[a], mesh.normals[b]) > 0.0f;
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!isEdge(a, b) || !isEdge(b, c) || !isEdge(c, a)) continue;
                const glm::vec3 *n = mesh.normals.data(), facing = glm::cross(n[b] - n[a], n[c] - n[a]);
                mesh.triangles.push_back(glm::dot(facing, n[a]) > 0.0f ? glm::uvec3(a, b, c)
                                                                       : glm::uvec3(a, c, b));
            }
    return mesh;
}

void subdivide(MeshData& mesh, LoadStep& step) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middleOf = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.normals.size()));
        if (isNew)
            mesh.normals.emplace_back(
                glm::normalize(glm::dvec3(mesh.normals[a]) + glm::dvec3(mesh.normals[b])));
        return found->second;
    };
    std::vector<glm::uvec3> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        const std::uint32_t xy = middleOf(t.x, t.y), yz = middleOf(t.y, t.z), zx = middleOf(t.z, t.x);
        step.advance();
        finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
    }
    mesh.triangles = std::move(finer);
}

}  // namespace

MeshData generate(const IcosphereShape& shape, const LoadControl& control) {
    MeshData mesh = icosahedron();
    // 20 (1 + 4 + 16 + …) triangles are split.
    LoadStep step(control, "generating a sphere", 20 * ((std::size_t{1} << 2 * shape.subdivisions) - 1) / 3);
    for (int i = 0; i < shape.subdivisions; ++i) subdivide(mesh, step);
    for (const glm::vec3& normal : mesh.normals) mesh.positions.push_back(shape.radius * normal);
    return mesh;
}

}  // namespace rayscope::scene
