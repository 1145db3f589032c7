#pragma once
#include <rayscope/lab.h>
#include <span>

namespace rayscope::measure {

/// An edge that exactly two triangles share.
struct SharedEdge {
    std::uint32_t a, b;  ///< vertices
    std::uint32_t triangles[2];
};

/// The triangles of a scene, and which of them meet where. Vertices at the same transform are one.
class LabMesh {
  public:
    explicit LabMesh(const SceneDescription& scene);

    const std::vector<glm::uvec3>& triangles() const { return triangles_; }
    const std::vector<SharedEdge>& edges() const { return edges_; }
    /// Vertices around which triangles stand without a gap: each edge at them is shared by two.
    const std::vector<std::uint32_t>& closedVertices() const { return closed_; }
    std::span<const std::uint32_t> trianglesAround(std::uint32_t vertex) const;
    double size() const { return size_; }
    glm::dvec3 center() const { return center_; }

    /// The vertices in a transform, rounded to float.
    std::vector<glm::vec3> verticesAt(const LabTransform& transform) const;
    /// Triangles with area here that have none with these vertices.
    std::uint64_t degenerate(const std::vector<glm::vec3>& moved) const;

  private:
    void weld(std::span<const glm::vec3> vertices, std::span<const glm::uvec3> triangles);
    void findEdges();
    void findFans();

    std::vector<glm::vec3> vertices_;
    std::vector<glm::uvec3> triangles_;
    std::vector<SharedEdge> edges_;
    std::vector<std::uint32_t> closed_, fanStart_, fans_, openEdges_;
    glm::dvec3 center_{0.0};
    double size_ = 0.0;
};

}  // namespace rayscope::measure
