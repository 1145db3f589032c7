#pragma once
#include <rayscope/lab.h>
#include <span>

namespace rayscope::measure {

/// An edge that exactly two triangles share.
struct SharedEdge {
    std::uint32_t a, b;  ///< vertices
    std::uint32_t triangles[2];
};

/// The triangles of a scene with their adjacency. Vertices at equal positions are merged; non-finite
/// triangles and those with two equal vertices are left out.
class LabMesh {
  public:
    explicit LabMesh(const SceneDescription& scene);

    /// Untransformed.
    const std::vector<glm::vec3>& vertices() const { return vertices_; }
    const std::vector<glm::uvec3>& triangles() const { return triangles_; }
    const std::vector<SharedEdge>& edges() const { return edges_; }
    /// Vertices all of whose edges are shared by exactly two triangles.
    const std::vector<std::uint32_t>& closedVertices() const { return closed_; }
    std::span<const std::uint32_t> trianglesAround(std::uint32_t vertex) const;
    double size() const { return size_; }
    glm::dvec3 center() const { return center_; }

    /// The transformed vertices, rounded to float.
    std::vector<glm::vec3> verticesAt(const LabTransform& transform) const;
    /// Number of triangles that have an area in the original mesh and none with these vertices.
    std::uint64_t degenerate(const std::vector<glm::vec3>& transformed) const;

  private:
    void weld(std::span<const glm::vec3> vertices, std::span<const glm::uvec3> triangles);
    void findEdges();
    void findVertexTriangles();

    std::vector<glm::vec3> vertices_;
    std::vector<glm::uvec3> triangles_;
    std::vector<SharedEdge> edges_;
    std::vector<std::uint32_t> closed_, openEdges_;
    /// Triangles around vertex v: elements firstTriangle_[v] … firstTriangle_[v + 1] of vertexTriangles_.
    std::vector<std::uint32_t> firstTriangle_, vertexTriangles_;
    glm::dvec3 center_{0.0};
    double size_ = 0.0;
};

}  // namespace rayscope::measure
