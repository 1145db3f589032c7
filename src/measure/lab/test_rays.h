#pragma once
// Generators of difficult rays, for the robustness test and for the tests of the tracer.
#include "measure/lab/lab_random.h"
#include "measure/lab/test_point.h"

namespace rayscope::measure {

/// A point on a shared edge or at a closed vertex, with the triangles around it.
struct SharedFeature {
    std::span<const std::uint32_t> triangles;
    std::uint32_t ends[2];  ///< the vertices of the edge, or the vertex twice
    glm::dvec3 point;
};
/// The mesh must have shared edges.
SharedFeature randomSharedFeature(const LabContext& context, LabRandom& random);

/// A ray to a point: from the surroundings of the mesh, from close by, from far away, or parallel to an axis
/// with zeros of either sign.
Ray rayAtPoint(const LabContext& context, const glm::dvec3& point, LabRandom& random);

/// A ray to a point of a triangle, from near or far; half of the points are close to an edge.
Ray rayAtTriangle(const LabContext& context, std::uint32_t triangle, LabRandom& random);

/// A direction above a plane; the sine of its elevation is 1e-4 … 1, log-uniform.
glm::vec3 directionAbove(const glm::dvec3& normal, LabRandom& random);

}  // namespace rayscope::measure
