#include "measure/many_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "bvh/isa.h"
#include "bvh/meshes.h"
#include "measure/lab/exact_sum.h"
#include "measure/lab/test_rays.h"
#include "trace/interaction.h"

namespace rayscope::test {
namespace {

constexpr std::size_t kBatch = 5000;

struct Transform {
    int exponent = 0;
    glm::dvec3 offset{0.0};  ///< in sizes; of few bits, so that a dyadic grid stays one
};

std::vector<Transform> transforms(double largestOffset) {
    std::vector<Transform> list;
    for (const int exponent : {-60, -20, 0, 20, 40, 60}) list.push_back({exponent, {}});
    for (const double offset : {1.0, 1e3, 1e6})
        if (offset <= largestOffset) list.push_back({0, {offset, -offset, std::floor(0.5 * offset)}});
    if (largestOffset >= 1e3) list.push_back({-30, {1e3, 1e3, -1e3}});
    return list;
}

TestGeometry transformed(const TestGeometry& unit, const Transform& transform) {
    const double scale = std::ldexp(1.0, transform.exponent);
    return unit.transformed(scale, scale * transform.offset);
}

SceneDescription sceneOf(const TestGeometry& geometry) {
    SceneDescription scene;
    auto data = std::make_shared<MeshData>();
    data->positions = geometry.vertices;
    data->triangles = geometry.triangles;
    scene.materials.emplace_back();
    scene.meshes.push_back({.name = geometry.name, .data = std::move(data), .materials = {0}});
    return scene;
}

/// A transformed mesh of about radius one before the transform, as the robustness test sees it.
struct Target {
    std::string name;
    Transform transform;
    measure::LabMesh mesh;
    std::shared_ptr<const trace::World> world;
    measure::LabContext context;
    std::vector<std::optional<Accel>> accels;  ///< by kernel, built on demand

    Target(const TestGeometry& unit, const Transform& t)
        : name(unit.name),
          transform(t),
          mesh(sceneOf(transformed(unit, t))),
          world(measure::worldOf(mesh, mesh.vertices(), Settings{})),
          context(measure::contextOf(mesh, *world, mesh.vertices(), mesh.size(), 0)) {}
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    double scale() const { return std::ldexp(1.0, transform.exponent); }
};

/// From well inside a target to a point of a shared edge, or to a vertex.
Ray aimedRay(const Target& target, measure::LabRandom& random) {
    const double scale = target.scale();
    glm::dvec3 inside;
    for (int axis = 0; axis < 3; ++axis)
        inside[axis] = (static_cast<double>(random.below(65)) - 32.0) / 128.0;
    Ray ray;
    ray.origin = glm::vec3(scale * (target.transform.offset + inside));
    const glm::dvec3 point = measure::randomSharedFeature(target.context, random).point;
    if (random.below(4) == 0) {  // parallel to an axis, if the line through the point passes well inside
        const auto axis = static_cast<int>(random.below(3));
        glm::dvec3 moved = point;
        moved[axis] = scale * target.transform.offset[axis];
        if (glm::length(moved / scale - target.transform.offset) < 0.5) {
            ray.origin = glm::vec3(moved);
            ray.direction = glm::vec3(random.coin() ? 0.0f : -0.0f);
            ray.direction[axis] = point[axis] < moved[axis] ? -1.0f : 1.0f;
            return ray;
        }
    }
    glm::dvec3 direction = point - glm::dvec3(ray.origin);
    if (random.coin()) direction = glm::normalize(direction / scale);
    ray.direction = glm::vec3(direction);
    return ray;
}

std::vector<Isa> kernels() {
    std::vector<Isa> list;
    for (const Isa isa : {Isa::Scalar, Isa::Sse2, Isa::Avx2, Isa::Avx512})
        if (bvh::isAvailable(isa)) list.push_back(isa);
    return list;
}

Accel accelOf(const measure::LabMesh& mesh, Isa isa) {
    BuildSettings settings;
    settings.isa = isa;
    return Accel::build({mesh.vertices(), mesh.triangles(), {}}, settings);
}

/// A grid in the plane x + 2y + 3z = 0 with integer coordinates: exactly coplanar in float.
TestGeometry tiltedPlane() {
    TestGeometry floor;
    for (int i = -8; i < 8; ++i)
        for (int j = -8; j < 8; ++j) {
            const auto at = [](int u, int v) { return glm::vec3(-2 * u - 3 * v, u, v); };
            floor.addTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            floor.addTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return floor;
}

/// Whether all vertices lie on or below the plane of every triangle, without rounding.
bool isConvex(const TestGeometry& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const glm::vec3& vertex : mesh.vertices)
            if (measure::signedVolume(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), vertex)
                    .sign() > 0)
                return false;
    return true;
}

/// Traces a ray to a triangle, and from its hit point one ray on each side. Returns false if nothing was hit.
bool traceSpawnedRay(const Target& target, bool closed, measure::LabRandom& random) {
    const auto triangle = static_cast<std::uint32_t>(random.below(target.mesh.triangles().size()));
    const Ray first = measure::rayAtTriangle(target.context, triangle, random);
    Hit hit;
    if (first.direction == glm::vec3(0.0f) || !target.world->closestHit(first, 0.0f, hit)) return false;
    const trace::Interaction at = trace::interactionAt(*target.world, first, 0.0f, {}, hit);
    const glm::dvec3 p = target.context.corner(hit.primitive, 0), q = target.context.corner(hit.primitive, 1),
                     r = target.context.corner(hit.primitive, 2);
    const bool fromOutside =
        glm::dot(at.geometricNormal, glm::cross((q - p) / target.scale(), (r - p) / target.scale())) > 0.0;
    for (const bool behind : {false, true}) {
        const glm::dvec3 normal = behind ? -at.geometricNormal : at.geometricNormal;
        const Ray next{behind ? at.originBehind() : at.originOutside(),
                       measure::directionAbove(normal, random)};
        const bool inward = closed && behind == fromOutside;
        Hit second;
        const bool found = target.world->closestHit(next, 0.0f, second);
        // From close to an edge, or at a small angle, an inward ray may leave through the neighbour at once.
        const float distance = std::min({hit.u, hit.v, 1.0f - hit.u - hit.v});
        if (inward && (glm::dot(glm::dvec3(next.direction), normal) < 0.01 || distance < 0.01f)) continue;
        EXPECT_EQ(found, inward) << target.name << ": " << text(next) << " from primitive " << hit.primitive;
        if (found != inward) return false;
        if (inward) {
            EXPECT_NE(second.primitive, hit.primitive) << text(next);
        }
    }
    return true;
}

}  // namespace

std::uint64_t traceRaysAtSharedEdges(std::uint64_t count) {
    std::uint64_t traced = 0;
    measure::LabRandom random(23, 0);
    const std::vector<Isa> isas = kernels();
    std::vector<std::unique_ptr<Target>> targets;
    for (const TestGeometry& unit :
         {icosphere(3, 0.0, 1), icosphere(4, 0.1, 3), needleSphere(8, 256), gridBox(16)})
        for (const Transform& transform : transforms(1e6)) {
            targets.push_back(std::make_unique<Target>(unit, transform));
            targets.back()->accels.resize(isas.size());
            const measure::LabMesh& mesh = targets.back()->mesh;
            EXPECT_FALSE(mesh.edges().empty());
            // Far from the origin vertices coincide after rounding, and edges may have more than two
            // triangles.
            if (transform.offset == glm::dvec3(0.0)) {
                EXPECT_EQ(mesh.closedVertices().size(), mesh.vertices().size());
            }
        }

    std::vector<Ray> rays(kBatch);
    std::vector<Hit> hits(kBatch);
    std::vector<std::uint8_t> occluded(kBatch);
    for (std::size_t round = 0; traced < count; ++round) {
        Target& target = *targets[round % targets.size()];
        // Successive targets use different kernels, so that few rounds cover all targets and all kernels.
        const std::size_t isa = (round + round / targets.size()) % isas.size();
        std::optional<Accel>& built = target.accels[isa];
        if (!built) built = accelOf(target.mesh, isas[isa]);
        const Accel& accel = *built;
        for (Ray& ray : rays) ray = aimedRay(target, random);
        const bool any = round % 3 == 2;
        any ? accel.anyHits(rays, occluded) : accel.closestHits(rays, hits);
        for (std::size_t i = 0; i < kBatch; ++i)
            if (any ? !occluded[i] : hits[i].primitive == kNoPrimitive) {
                ADD_FAILURE() << "leak after " << traced + i << " rays: " << target.name << " at 2^"
                              << target.transform.exponent << ", isa "
                              << static_cast<int>(accel.summary().isa) << ": " << text(rays[i]);
                return traced;
            }
        traced += kBatch;
    }
    return traced;
}

std::uint64_t traceSpawnedRays(std::uint64_t count) {
    measure::LabRandom random(29, 0);
    std::vector<std::unique_ptr<Target>> convex, plane;
    for (const Transform& transform : transforms(1e3))
        for (const TestGeometry& unit : {icosphere(2, 0.0, 1), gridBox(4)})
            if (isConvex(transformed(unit, transform)))
                convex.push_back(std::make_unique<Target>(unit, transform));
    EXPECT_GE(convex.size(), 8u);
    for (const Transform& transform : transforms(1e6))
        plane.push_back(std::make_unique<Target>(tiltedPlane(), transform));
    std::uint64_t spawned = 0;
    for (std::size_t round = 0; spawned < count; ++round) {
        const std::size_t i = round % (convex.size() + plane.size());
        const bool closed = i < convex.size();
        const Target& target = closed ? *convex[i] : *plane[i - convex.size()];
        for (std::size_t k = 0; k < kBatch / 2; ++k) {
            spawned += traceSpawnedRay(target, closed, random) ? 2 : 0;
            if (testing::Test::HasFailure()) return spawned;
        }
    }
    return spawned;
}

}  // namespace rayscope::test
