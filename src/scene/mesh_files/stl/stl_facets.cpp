#include "scene/mesh_files/stl/stl_facets.h"

#include <algorithm>
#include <utility>

#include "math/vectors.h"

namespace rayscope::scene {

StlFacets::StlFacets(std::uint64_t expected, Oddities& oddities)
    // A closed mesh has half as many vertices as triangles, one with a border some more.
    : oddities_(oddities), vertices_(static_cast<std::size_t>(expected / 2 + expected / 16)) {
    triangles_.reserve(static_cast<std::size_t>(expected));
}

void StlFacets::add(const StlFacet& facet, int line) {
    const auto& [a, b, c] = facet.corners;
    std::copy(facet.corners.begin(), facet.corners.end(),
              corners_.begin() + static_cast<std::ptrdiff_t>(3 * waiting_));
    lines_[waiting_] = line;
    const glm::dvec3 area = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    if (glm::dot(area, glm::dvec3(facet.normal)) < 0.0)
        oddities_.add(Severity::Note,
                      "normals of facets that disagree with the order of the corners; the order is used",
                      line);
    if (++waiting_ == kMost) flush();
}

void StlFacets::flush() {
    std::array<std::uint32_t, 3 * kMost> indices;
    vertices_.indicesOf({corners_.data(), 3 * waiting_}, indices.data());
    for (std::size_t i = 0; i < waiting_; ++i) {
        const glm::uvec3 triangle(indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]);
        triangles_.push_back(triangle);
        if (triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x)
            oddities_.add(Severity::Note, "degenerate facets (two corners are equal); rays never hit them",
                          lines_[i]);
        for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner)
            if (!math::isFinite(corners_[corner]))
                oddities_.add(Severity::Note,
                              "vertices with NaN or infinite coordinates; rays never hit their triangles",
                              lines_[i]);
    }
    waiting_ = 0;
}

MeshData StlFacets::finish(const std::string& path) {
    flush();
    if (triangles_.empty()) throw InputError("the file has no facets", {path});
    MeshData mesh;
    mesh.positions = vertices_.takePoints();
    mesh.triangles = std::move(triangles_);
    return mesh;
}

}  // namespace rayscope::scene
