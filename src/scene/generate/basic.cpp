// The rectangle and the box.
#include "scene/generate/generate.h"

namespace rayscope::scene {

namespace {

/// Appends the rectangle with the given centre and half sides u, v; its normal is u × v.
void addFace(MeshData& mesh, glm::vec3 center, glm::vec3 u, glm::vec3 v) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    // In double: the product of two sides may leave the range of float.
    const glm::vec3 normal(glm::normalize(glm::cross(glm::dvec3(u), glm::dvec3(v))));
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        mesh.positions.push_back(center + (2.0f * corner.x - 1.0f) * u + (2.0f * corner.y - 1.0f) * v);
        mesh.normals.push_back(normal);
        mesh.texCoords.push_back(corner);
    }
    mesh.triangles.emplace_back(base, base + 1, base + 2);
    mesh.triangles.emplace_back(base, base + 2, base + 3);
}

}  // namespace

MeshData generate(const QuadShape& shape) {
    MeshData mesh;
    addFace(mesh, {0, 0, 0}, {0.5f * shape.size.x, 0, 0}, {0, 0.5f * shape.size.y, 0});
    return mesh;
}

MeshData generate(const BoxShape& shape) {
    MeshData mesh;
    const glm::vec3 half = 0.5f * shape.size;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {1.0f, -1.0f}) {
            // On the walls u is horizontal and v vertical, so that textures are upright.
            glm::vec3 outward(0.0f), u(0.0f), v(0.0f);
            outward[axis] = side * half[axis];
            if (axis == 0) u.z = -side * half.z, v.y = half.y;
            if (axis == 1) u.x = half.x, v.z = -side * half.z;
            if (axis == 2) u.x = side * half.x, v.y = half.y;
            addFace(mesh, outward, shape.inward ? -u : u, v);
        }
    return mesh;
}

}  // namespace rayscope::scene
