#pragma once
#include "measure/lab/mesh.h"
#include "trace/world.h"

namespace rayscope::measure {

/// What some rays of a testPoint showed.
struct LabTally {
    std::array<LabCounts, kLabMethods.size()> counts;
    std::uint64_t undecided = 0;
    std::vector<LabFailure> failures;

    LabCounts& of(LabMethod method) { return counts[static_cast<std::size_t>(method)]; }
    void fail(LabMethod method, LabFailureKind fault, const Ray& ray);
    void add(const LabTally& other);
};

/// One transform of the mesh, ready to be shot at.
struct LabContext {
    const LabMesh& mesh;
    const trace::World& world;  ///< holds the moved mesh and nothing else
    std::span<const glm::vec3> vertices;
    glm::dvec3 center{0.0};  ///< of the moved mesh
    double size = 0.0;
    std::uint64_t seed = 0;

    glm::vec3 corner(std::uint32_t triangle, int k) const { return vertices[mesh.triangles()[triangle][k]]; }
};

/// Ray number `index` of those at shared edges and vertices.
void testWatertightness(const LabContext& target, std::uint64_t index, LabTally& tally);

/// Surface point number `index`: rays that leave it, and a second surface just above it.
void testSpawnedRay(const LabContext& target, std::uint64_t index, LabTally& tally);

/// Compares a hit of the tracer with the exact answer.
void checkHit(const LabContext& target, const Ray& ray, const Hit& hit, LabTally& tally);

}  // namespace rayscope::measure
