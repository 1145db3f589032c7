#include "scene/mesh_files/geometry/missing_normals.h"

namespace rayscope::scene {

void computeMissingNormals(const std::vector<bool>& isMissing, MeshData& mesh) {
    // Squares of edges span 1e-90 … 1e77, and squares of areas 1e-180 … 1e155: within the range of double.
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 area = glm::cross(b - a, c - a);
        for (const std::uint32_t vertex : {t.x, t.y, t.z})
            if (isMissing[vertex]) sums[vertex] += area;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (!isMissing[i]) continue;
        const double length = glm::length(sums[i]);
        mesh.normals[i] = length > 0.0 ? glm::vec3(sums[i] / length) : glm::vec3(0.0f);
    }
}

}  // namespace rayscope::scene
