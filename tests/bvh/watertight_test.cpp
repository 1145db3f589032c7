// Closed meshes: rays from inside never leak, and cross the surface exactly once, also through edges and
// vertices.
#include <gtest/gtest.h>

#include <cmath>

#include "bvh/intersect/intersect_triangle.h"
#include "bvh/isa.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

enum class Aim { Edge, Vertex, VertexFromCenter, VertexUnit, AxisParallel };
constexpr Aim kAims[] = {Aim::Edge, Aim::Vertex, Aim::VertexFromCenter, Aim::VertexUnit, Aim::AxisParallel};

/// The transform of the mesh: scale, then offset.
struct Placement {
    double scale = 1.0;
    glm::dvec3 offset{0.0};
};

/// A ray from well inside the mesh towards an edge or a vertex; from a dyadic origin some hit it exactly.
Ray aimedRay(const TestGeometry& mesh, const Placement& placement, Aim aim, Random& random) {
    const auto triangle = static_cast<std::size_t>(random.integer(static_cast<int>(mesh.triangles.size())));
    const int k = random.integer(3);
    const glm::dvec3 a = mesh.corner(triangle, k), b = mesh.corner(triangle, (k + 1) % 3);
    glm::dvec3 inside;
    for (int axis = 0; axis < 3; ++axis) inside[axis] = (random.integer(65) - 32) / 128.0;
    if (aim == Aim::VertexFromCenter) inside = {};
    Ray ray;
    ray.origin = glm::vec3(placement.offset + placement.scale * inside);
    if (aim == Aim::AxisParallel) {
        // Move the origin onto the axis-parallel line through the vertex, if that passes well inside the
        // mesh.
        const int axis = random.integer(3);
        glm::vec3 moved(a);
        moved[axis] = static_cast<float>(placement.offset[axis]);
        if (glm::length(glm::dvec3(moved) - placement.offset) < 0.5 * placement.scale) {
            ray.origin = moved;
            ray.direction = glm::vec3(random.integer(2) ? 0.0f : -0.0f);
            ray.direction[axis] = a[axis] < placement.offset[axis] ? -1.0f : 1.0f;
            return ray;
        }
    }
    const glm::dvec3 target = aim == Aim::Edge ? a + (random.integer(257) / 256.0) * (b - a) : a;
    glm::dvec3 direction = target - glm::dvec3(ray.origin);
    if (aim == Aim::VertexUnit) direction = glm::normalize(direction);
    ray.direction = glm::vec3(direction);
    return ray;
}

int crossings(const TestGeometry& mesh, const Ray& ray) {
    const bvh::ShearedRay sheared(bvh::rayData(ray));
    int count = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        bvh::TriangleHit hit;
        count += bvh::intersectTriangle(sheared, mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z],
                                        hit) &&
                 hit.t > 0.0;
    }
    return count;
}

std::vector<Placement> placements() {
    std::vector<Placement> result;
    for (const int exponent : {-60, -40, -20, 0, 20, 40, 60}) result.push_back({std::exp2(exponent), {}});
    for (const double offset : {1.0, 1e3, 1e6}) result.push_back({1.0, {offset, -offset, 0.5 * offset}});
    for (const int exponent : {-30, 30})
        result.push_back({std::exp2(exponent), std::exp2(exponent) * glm::dvec3(1e5, 1e5, -1e5)});
    return result;
}

/// With single and batched queries of every kernel.
void expectNoLeak(const TestGeometry& mesh, const std::vector<Ray>& rays) {
    for (const Isa isa : {Isa::Scalar, Isa::Sse2, Isa::Avx2, Isa::Avx512}) {
        if (!bvh::isAvailable(isa)) continue;
        BuildSettings settings;
        settings.isa = isa;
        const Accel accel = Accel::build(mesh.input(), settings);
        std::vector<Hit> hits(rays.size());
        std::vector<std::uint8_t> occluded(rays.size());
        accel.closestHits(rays, hits);
        accel.anyHits(rays, occluded);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Hit hit;
            ASSERT_TRUE(accel.closestHit(rays[i], hit)) << mesh.name << ": " << text(rays[i]);
            ASSERT_TRUE(accel.anyHit(rays[i])) << mesh.name << ": " << text(rays[i]);
            ASSERT_NE(hits[i].primitive, kNoPrimitive) << mesh.name << ", batched: " << text(rays[i]);
            ASSERT_TRUE(occluded[i]) << mesh.name << ", batched: " << text(rays[i]);
        }
    }
}

class WatertightMesh : public testing::TestWithParam<int> {
  protected:
    static TestGeometry mesh(int which) {
        return which == 0 ? icosphere(3, 0.0, 1) : which == 1 ? needleSphere(4, 256) : gridBox(8);
    }
};

TEST_P(WatertightMesh, NoRayLeaksOutOfAClosedMesh) {
    const TestGeometry unit = mesh(GetParam());
    Random random(17);
    for (const Placement& placement : placements()) {
        const TestGeometry moved = unit.transformed(placement.scale, placement.offset);
        std::vector<Ray> rays;
        for (const Aim aim : kAims)
            for (int i = 0; i < 500; ++i) rays.push_back(aimedRay(moved, placement, aim, random));
        expectNoLeak(moved, rays);
    }
}

TEST_P(WatertightMesh, EveryRayCrossesAConvexMeshOnce) {
    const TestGeometry unit = mesh(GetParam());
    Random random(18);
    for (const Placement& placement : placements()) {
        if (placement.offset != glm::dvec3(0.0) && glm::length(placement.offset) > 2e3 * placement.scale)
            continue;  // rounded to a coarse grid it is no longer convex
        const TestGeometry moved = unit.transformed(placement.scale, placement.offset);
        for (const Aim aim : kAims)
            for (int i = 0; i < 200; ++i) {
                const Ray ray = aimedRay(moved, placement, aim, random);
                ASSERT_EQ(crossings(moved, ray), 1)
                    << moved.name << " scale " << placement.scale << ": " << text(ray);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, WatertightMesh, testing::Range(0, 3), [](const auto& mesh) {
    return std::string(mesh.param == 0 ? "Icosphere" : mesh.param == 1 ? "Needles" : "GridBox");
});

TEST(Watertight, RefittedMeshesAreWatertight) {
    for (const Placement& placement : placements()) {
        Random random(21);
        const TestGeometry bumpy = icosphere(4, 0.1, 3).transformed(placement.scale, placement.offset);
        const Accel accel = Accel::build(bumpy.input());
        for (const Aim aim : kAims)
            for (int i = 0; i < 5000; ++i) {
                const Ray ray = aimedRay(bumpy, placement, aim, random);
                ASSERT_TRUE(accel.anyHit(ray)) << "scale " << placement.scale << ": " << text(ray);
                if (i % 100 == 0) {
                    ASSERT_EQ(crossings(bumpy, ray) % 2, 1) << text(ray);
                }
            }
    }
}

/// Vertices on a grid whose lines the rays hit exactly: nearly all are ties.
TEST(Watertight, RaysAlongTheGridOfAFlatFloorCrossItOnce) {
    TestGeometry floor;
    for (int x = -8; x < 8; ++x)
        for (int y = -8; y < 8; ++y) {
            floor.addTriangle({x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0});
            floor.addTriangle({x, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
        }
    const Accel accel = Accel::build(floor.input());
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 target((random.integer(57) - 28) / 4.0, (random.integer(57) - 28) / 4.0, 0);
        const glm::vec3 direction(random.integer(5) - 2, random.integer(5) - 2, random.integer(2) ? -1 : 1);
        const Ray ray{target - 3.0f * direction, direction};
        Hit hit;
        ASSERT_EQ(crossings(floor, ray), 1) << text(ray);
        ASSERT_TRUE(accel.closestHit(ray, hit)) << text(ray);
        ASSERT_EQ(hit.t, 3.0f) << text(ray);
    }
}

}  // namespace
}  // namespace rayscope::test
