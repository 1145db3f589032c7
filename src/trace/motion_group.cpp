#include "trace/motion_group.h"

#include <algorithm>

#include "base/memory_budget.h"

namespace rayscope::trace {

namespace {

/// Collects the objects of one motion; seal() ends it.
class GeometryBuilder {
  public:
    explicit GeometryBuilder(const glm::vec3& motion) { geometry_->motion = motion; }
    const glm::vec3& motion() const { return geometry_->motion; }

    void addMesh(const MeshInstance& mesh, std::uint32_t object) {
        geometry_->keptMeshes.push_back(mesh);
        meshObjects_.push_back(object);
    }
    void addSphere(const SphereInstance& sphere, std::uint32_t object) {
        geometry_->ownSpheres.push_back(sphere.sphere);
        ObjectRange range{0, 1, object};
        range.material = sphere.material;
        sphereRanges_.push_back(range);
    }

    std::shared_ptr<const Geometry> seal() {
        const bool single =
            geometry_->keptMeshes.size() == 1 && geometry_->keptMeshes[0].transform.isIdentity();
        for (std::size_t i = 0; i < geometry_->keptMeshes.size(); ++i) placeMesh(i, single);
        AccelInput& input = geometry_->input;
        if (!single) {
            input.vertices = geometry_->ownVertices;
            input.triangles = geometry_->ownTriangles;
        }
        input.spheres = geometry_->ownSpheres;
        for (ObjectRange range : sphereRanges_) {
            range.first = next_++;
            geometry_->objects.push_back(range);
        }
        return geometry_;
    }

  private:
    void placeMesh(std::size_t i, bool shareData) {
        const MeshInstance& mesh = geometry_->keptMeshes[i];
        const MeshData& data = *mesh.data;
        ObjectRange range{next_, static_cast<std::uint32_t>(data.triangles.size()), meshObjects_[i], &data,
                          &mesh.materials};
        if (mesh.vertexColors && !data.colors.empty()) range.colors = &data.colors;
        if (shareData) {
            geometry_->input.vertices = data.positions;
            geometry_->input.triangles = data.triangles;
        } else {
            appendTransformed(mesh, range);
        }
        next_ += range.count;
        geometry_->objects.push_back(range);
    }

    void appendTransformed(const MeshInstance& mesh, ObjectRange& range) {
        const auto base = static_cast<std::uint32_t>(geometry_->ownVertices.size());
        const bool identity = mesh.transform.isIdentity();
        const glm::dmat4 matrix = matrixOf(mesh.transform);
        base::requireMemory(mesh.data->positions.size() * sizeof(glm::vec3) +
                                mesh.data->triangles.size() * sizeof(glm::uvec3),
                            "a smaller scene", "the placed copy of a mesh of {} triangles",
                            mesh.data->triangles.size());
        geometry_->ownVertices.reserve(base + mesh.data->positions.size());
        for (const glm::vec3& p : mesh.data->positions)
            geometry_->ownVertices.push_back(identity ? p : glm::vec3(matrix * glm::dvec4(p, 1.0)));
        geometry_->ownTriangles.reserve(geometry_->ownTriangles.size() + mesh.data->triangles.size());
        for (const glm::uvec3& triangle : mesh.data->triangles)
            geometry_->ownTriangles.push_back(triangle + base);
        if (identity) return;
        range.transformed = true;
        // Normals transform with the cofactor matrix, which exists even if the inverse does not.
        const glm::dmat3 linear(matrix);
        range.normalMatrix = glm::dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                        glm::cross(linear[0], linear[1]));
        if (glm::determinant(linear) < 0.0) range.normalMatrix = -range.normalMatrix;
    }

    std::shared_ptr<Geometry> geometry_ = std::make_shared<Geometry>();
    std::vector<std::uint32_t> meshObjects_;
    std::vector<ObjectRange> sphereRanges_;
    std::uint32_t next_ = 0;
};

}  // namespace

const ObjectRange& Geometry::objectOf(std::uint32_t primitive) const {
    const auto after =
        std::upper_bound(objects.begin(), objects.end(), primitive,
                         [](std::uint32_t p, const ObjectRange& range) { return p < range.first; });
    return *std::prev(after);
}

std::vector<std::shared_ptr<const Geometry>> makeGeometry(const SceneDescription& scene, bool withMotion) {
    std::vector<GeometryBuilder> builders;
    const auto builderFor = [&](const glm::vec3& wanted) -> GeometryBuilder& {
        const glm::vec3 motion = withMotion ? wanted : glm::vec3(0.0f);
        for (GeometryBuilder& builder : builders)
            if (builder.motion() == motion) return builder;
        return builders.emplace_back(motion);
    };
    std::uint32_t object = 0;
    for (const MeshInstance& mesh : scene.meshes) builderFor(mesh.motion).addMesh(mesh, object++);
    for (const SphereInstance& sphere : scene.spheres) builderFor(sphere.motion).addSphere(sphere, object++);

    std::vector<std::shared_ptr<const Geometry>> geometries;
    for (GeometryBuilder& builder : builders) geometries.push_back(builder.seal());
    return geometries;
}

bool sameGeometry(const SceneDescription& a, const SceneDescription& b) {
    const auto sameMesh = [](const MeshInstance& x, const MeshInstance& y) {
        return x.data == y.data && x.transform == y.transform && x.materials == y.materials &&
               x.motion == y.motion && x.vertexColors == y.vertexColors;
    };
    return std::ranges::equal(a.meshes, b.meshes, sameMesh) && a.spheres == b.spheres;
}

}  // namespace rayscope::trace
