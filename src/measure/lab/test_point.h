#pragma once
#include "measure/lab/lab_mesh.h"
#include "trace/world.h"

namespace rayscope::measure {

/// Counts and failures of some rays of a test point.
struct LabTally {
    std::array<LabCounts, kLabMethods.size()> counts;
    std::uint64_t undecided = 0;
    std::vector<LabFailure> failures;

    LabCounts& of(LabMethod method) { return counts[static_cast<std::size_t>(method)]; }
    void fail(LabMethod method, LabFailureKind kind, const Ray& ray);
    void add(const LabTally& other);
};

/// The transformed mesh of one test point.
struct LabContext {
    const LabMesh& mesh;
    const trace::World& world;  ///< nothing but the transformed mesh
    std::span<const glm::vec3> vertices;
    glm::dvec3 center{0.0};  ///< of the transformed mesh
    double size = 0.0;
    std::uint64_t seed = 0;

    glm::vec3 corner(std::uint32_t triangle, int k) const { return vertices[mesh.triangles()[triangle][k]]; }
};

/// A world with nothing but the mesh, with these vertices. Throws Stopped.
std::shared_ptr<const trace::World> worldOf(const LabMesh& mesh, const std::vector<glm::vec3>& vertices,
                                            const Settings& settings, const std::stop_token& stop = {});

/// The arguments must outlive the context. `size` is that of the transformed mesh.
LabContext contextOf(const LabMesh& mesh, const trace::World& world, const std::vector<glm::vec3>& vertices,
                     double size, std::uint64_t seed);

/// Tests ray `index` at a shared edge or vertex: it must hit an odd number of the triangles around it.
void testWatertightness(const LabContext& context, std::uint64_t index, LabTally& tally);

/// Tests spawned ray `index`: it must not hit its own surface, and must hit a second one just above it.
void testSpawnedRay(const LabContext& context, std::uint64_t index, LabTally& tally);

/// Compares a hit of the tracer with the exact crossing.
void checkHit(const LabContext& context, const Ray& ray, const Hit& hit, LabTally& tally);

}  // namespace rayscope::measure
