#pragma once
// Geometry in world space, grouped by motion: the input of the BVHs.
#include <rayscope/accel.h>
#include <rayscope/scene.h>

#include <memory>
#include <span>
#include <vector>

namespace rayscope::trace {

/// The primitives of one mesh or sphere within a motion group, with their attributes.
struct ObjectRange {
    std::uint32_t first = 0, count = 0;  ///< primitives of the motion group
    std::uint32_t object = 0;            ///< number of the mesh, or of the sphere after all meshes
    const MeshData* mesh = nullptr;      ///< null for a sphere
    const std::vector<std::uint32_t>* materials = nullptr;  ///< of a mesh: slot → material
    std::uint32_t material = 0;                             ///< of a sphere
    const std::vector<Rgb>* colors = nullptr;               ///< vertex colours of a mesh that shows them
    bool transformed = false;                               ///< normals of the mesh need `normalMatrix`
    glm::dmat3 normalMatrix{1.0};
};

/// Positions, triangles and spheres in world space at the start of the shutter. The spans of `input` refer to
/// the mesh itself if it is the only one and not transformed, else to the storage of this object.
struct Geometry {
    AccelInput input;
    std::vector<ObjectRange> objects;  ///< ordered by `first`: meshes, then spheres
    glm::vec3 motion{0.0f};            ///< displacement from the start to the end of the shutter

    std::vector<glm::vec3> ownVertices;
    std::vector<glm::uvec3> ownTriangles;
    std::vector<Sphere> ownSpheres;
    std::vector<MeshInstance> keptMeshes;  ///< own what the spans and ranges refer to

    const ObjectRange& objectOf(std::uint32_t primitive) const;

    /// Displacement at a time of the shutter in [0, 1).
    glm::dvec3 displacement(float time) const { return static_cast<double>(time) * glm::dvec3(motion); }
    /// The ray at that time in the rest frame, which moves with the geometry.
    Ray inRestFrame(const Ray& ray, float time) const {
        Ray moved = ray;
        moved.origin = glm::vec3(glm::dvec3(ray.origin) - displacement(time));
        return moved;
    }
};

/// One motion group for everything at rest and one for each distinct motion; all at rest if `withMotion` is
/// false.
std::vector<std::shared_ptr<const Geometry>> makeGeometry(const SceneDescription& scene, bool withMotion);

/// Whether two descriptions have equal shapes, transforms and motions, so that geometry can be shared.
bool sameGeometry(const SceneDescription& a, const SceneDescription& b);

}  // namespace rayscope::trace
