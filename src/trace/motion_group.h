#pragma once
// Geometry in the form that rays search: one motionGroup holds everything that moves alike.
#include <rayscope/accel.h>
#include <rayscope/scene.h>

#include <memory>
#include <span>
#include <vector>

namespace rayscope::trace {

/// The primitives of one mesh or sphere within a motionGroup, and where their attributes stand.
struct ObjectRange {
    std::uint32_t first = 0, count = 0;  ///< primitives of the motionGroup
    std::uint32_t object = 0;            ///< number of the mesh, or of the sphere after all meshes
    const MeshData* mesh = nullptr;      ///< null for a sphere
    const std::vector<std::uint32_t>* materials = nullptr;  ///< of a mesh: slot → material
    std::uint32_t material = 0;                             ///< of a sphere
    bool transformed = false;                               ///< normals of the mesh need `normalMatrix`
    glm::dmat3 normalMatrix{1.0};
};

/// Positions, triangles and spheres in world space at the start of the shutter. Spans refer to the mesh
/// itself where it can be used as it is, else to the storage beside them.
struct Geometry {
    AccelInput input;
    std::vector<ObjectRange> objects;  ///< ordered by `first`: meshes, then spheres
    glm::vec3 motion{0.0f};            ///< displacement over the time of the shutter

    std::vector<glm::vec3> ownVertices;
    std::vector<glm::uvec3> ownTriangles;
    std::vector<Sphere> ownSpheres;
    std::vector<MeshInstance> keptMeshes;  ///< keeps what the spans and ranges refer to alive

    const ObjectRange& objectOf(std::uint32_t primitive) const;

    /// How far everything has moved at a time of the shutter in [0, 1).
    glm::dvec3 displacement(float time) const { return static_cast<double>(time) * glm::dvec3(motion); }
    /// The ray at that time, in the frame in which nothing moves.
    Ray inRestFrame(const Ray& ray, float time) const {
        Ray moved = ray;
        moved.origin = glm::vec3(glm::dvec3(ray.origin) - displacement(time));
        return moved;
    }
};

/// One motionGroup for everything at rest and one for each distinct motion; all at rest if `withMotion` is
/// false.
std::vector<std::shared_ptr<const Geometry>> makeGeometry(const SceneDescription& scene, bool withMotion);

/// Whether two descriptions have the same shapes in the same places, so that geometry can be shared between
/// them.
bool sameGeometry(const SceneDescription& a, const SceneDescription& b);

}  // namespace rayscope::trace
