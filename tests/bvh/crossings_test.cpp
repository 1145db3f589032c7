// All hits of a ray: those of brute force, in order; closed meshes are crossed an even number of times from
// outside and an odd number from inside, also through edges and vertices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bvh/meshes.h"
#include "bvh/traversal/crossings.h"
#include "bvh/traversal_cases.h"

namespace rayscope::test {
namespace {

using testing::ElementsAre;

std::vector<Hit> crossingsOf(const Accel& accel, const Ray& ray) {
    std::vector<Hit> found(3);  // is replaced
    accel.crossings(ray, found);
    return found;
}

std::vector<float> distancesOf(const Accel& accel, const Ray& ray) {
    std::vector<float> t;
    for (const Hit& hit : crossingsOf(accel, ray)) t.push_back(hit.t);
    return t;
}

void expectEqualsBruteForce(const TestGeometry& scene, const std::vector<Ray>& rays, const Accel& accel,
                            const std::string& name) {
    for (const Ray& ray : rays) {
        const std::vector<Hit> expected = bvh::crossingsBruteForce(scene.input(), ray);
        const std::vector<Hit> found = crossingsOf(accel, ray);
        const std::string where = scene.name + ", " + name + ": " + text(ray);
        ASSERT_EQ(found.size(), expected.size()) << where;
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_TRUE(sameHit(found[i], expected[i])) << where << ", crossing " << i;
        ASSERT_EQ(accel.countCrossings(ray), expected.size()) << where;
        Hit closest;
        ASSERT_EQ(accel.closestHit(ray, closest), !found.empty()) << where;
        if (!found.empty()) {
            ASSERT_TRUE(sameHit(found[0], closest)) << where;
        }
    }
}

TEST(Crossings, EveryTreeAndKernelEqualsBruteForce) {
    for (const TestGeometry& scene : edgeCaseScenes()) {
        const std::vector<Ray> rays = edgeCaseRays(scene, 300, 5);
        for (const TraversalCase& traversalCase : traversalCases())
            for (const BvhBuilder builder : {BvhBuilder::Median, BvhBuilder::SahReinsertion}) {
                BuildSettings settings;
                settings.builder = builder;
                expectEqualsBruteForce(scene, rays, build(scene, settings, traversalCase),
                                       traversalCase.name);
            }
    }
}

TEST(Crossings, AreInOrderAndWithinTheInterval) {
    TestGeometry layers;
    constexpr int kLayers = 1000;
    for (int i = kLayers - 1; i >= 0; --i) layers.addTriangle({-1, -1, i}, {3, -1, i}, {-1, 3, i});
    const Accel accel = Accel::build(layers.input());
    const std::vector<float> all = distancesOf(accel, {{0.25f, 0.25f, -1}, {0, 0, 1}});
    ASSERT_EQ(all.size(), std::size_t{kLayers});
    for (int i = 0; i < kLayers; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], static_cast<float>(i + 1));
    EXPECT_THAT(distancesOf(accel, {{0.25f, 0.25f, -1}, {0, 0, 1}, 3.0f, 5.0f}), ElementsAre(4.0f, 5.0f));
    EXPECT_THAT(distancesOf(accel, {{0.25f, 0.25f, 1.5f}, {0, 0, -0.5f}}), ElementsAre(1.0f, 3.0f));
}

TEST(Crossings, CoincidentTrianglesAreSeparateHitsInTheOrderOfTheirNumbers) {
    TestGeometry twice;
    for (int i = 0; i < 3; ++i) twice.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const std::vector<Hit> found = crossingsOf(Accel::build(twice.input()), {{0.25f, 0.25f, 1}, {0, 0, -1}});
    ASSERT_EQ(found.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(found[i].primitive, i);
}

TEST(Crossings, SpheresAreEnteredAndLeft) {
    TestGeometry spheres;
    spheres.spheres = {{{0, 0, 0}, 1.0f}, {{0, 0, 0}, 2.0f}};
    const Accel accel = Accel::build(spheres.input());
    EXPECT_THAT(distancesOf(accel, {{0, 0, -3}, {0, 0, 1}}), ElementsAre(1.0f, 2.0f, 4.0f, 5.0f));
    EXPECT_THAT(distancesOf(accel, {{0, 0, -3}, {0, 0, 2}, 0.5f, 2.0f}), ElementsAre(1.0f, 2.0f));
    EXPECT_THAT(distancesOf(accel, {{0, 0, 0}, {0, 1, 0}}), ElementsAre(1.0f, 2.0f));
    EXPECT_FALSE(accel.contains({0, 0, 0})) << "inside both: even";
    EXPECT_TRUE(accel.contains({0, 1.5f, 0}));
    EXPECT_FALSE(accel.contains({0, 2.5f, 0}));
}

TEST(Crossings, WithoutGeometryThereAreNone) {
    const Accel empty;
    EXPECT_THAT(distancesOf(empty, {}), ElementsAre());
    EXPECT_EQ(empty.countCrossings({}), 0u);
    EXPECT_FALSE(empty.contains({0, 0, 0}));
    const TestGeometry box = gridBox(1);
    const Accel accel = Accel::build(box.input());
    for (const float bad : {NAN, INFINITY}) {
        EXPECT_FALSE(accel.contains({bad, 0, 0}));
        EXPECT_EQ(accel.countCrossings({{0, 0, bad}, {0, 0, 1}}), 0u);
        EXPECT_EQ(accel.countCrossings({{0, 0, 0}, {0, bad, 1}}), 0u);
    }
}

/// A fan of triangles around an apex, as a closed cone.
TestGeometry cone(int segments) {
    TestGeometry mesh;
    mesh.name = "cone";
    mesh.vertices = {{0, 0, 1}, {0, 0, 0}};
    for (int i = 0; i < segments; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / segments;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    const auto n = static_cast<unsigned>(segments);
    for (unsigned i = 0; i < n; ++i) {
        mesh.triangles.emplace_back(0u, 2 + i, 2 + (i + 1) % n);
        mesh.triangles.emplace_back(1u, 2 + (i + 1) % n, 2 + i);
    }
    return mesh;
}

TEST(Crossings, AFanIsCrossedOnceAtItsApex) {
    for (const int segments : {3, 4, 100, 1000}) {
        const TestGeometry mesh = cone(segments);
        const Accel accel = Accel::build(mesh.input());
        // Along the axis, through both centers of the fans.
        EXPECT_THAT(distancesOf(accel, {{0, 0, 3}, {0, 0, -1}}), ElementsAre(2.0f, 3.0f)) << segments;
        EXPECT_THAT(distancesOf(accel, {{0, 0, 0.5f}, {0, 0, 1}}), ElementsAre(0.5f)) << segments;
        // Past the apex, which the ray touches.
        EXPECT_EQ(accel.countCrossings({{-3, 0, 1}, {1, 0, 0}}) % 2, 0u) << segments;
    }
}

TEST(Crossings, ABoxIsEnteredAndLeftOnceThroughTheDiagonalsOfItsFaces) {
    const TestGeometry box = gridBox(1);  // two triangles per face
    glm::vec3 lower(INFINITY), upper(-INFINITY);
    for (const glm::vec3& vertex : box.vertices) {
        lower = glm::min(lower, vertex);
        upper = glm::max(upper, vertex);
    }
    const glm::vec3 size = upper - lower;
    const Accel accel = Accel::build(box.input());
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 1; i < 8; ++i)
            for (int j = 1; j < 8; ++j) {
                Ray ray;
                ray.origin[axis] = lower[axis] - size[axis];
                ray.origin[(axis + 1) % 3] =
                    lower[(axis + 1) % 3] + static_cast<float>(i) / 8.0f * size[(axis + 1) % 3];
                ray.origin[(axis + 2) % 3] =
                    lower[(axis + 2) % 3] + static_cast<float>(j) / 8.0f * size[(axis + 2) % 3];
                ray.direction = glm::vec3(0.0f);
                ray.direction[axis] = size[axis];
                EXPECT_THAT(distancesOf(accel, ray), ElementsAre(1.0f, 2.0f)) << text(ray);
            }
}

TEST(Crossings, PointsOfALatticeAreInsideABoxWhereTheyAre) {
    const TestGeometry box = gridBox(4);
    const Accel accel = Accel::build(box.input());
    glm::vec3 lower(INFINITY), upper(-INFINITY);
    for (const glm::vec3& vertex : box.vertices) {
        lower = glm::min(lower, vertex);
        upper = glm::max(upper, vertex);
    }
    // The planes of many of these points hold edges of the mesh.
    for (int x = -7; x <= 7; ++x)
        for (int y = -7; y <= 7; ++y)
            for (int z = -7; z <= 7; ++z) {
                const glm::vec3 point = glm::vec3(x, y, z) / 4.0f * upper;
                const bool isOnSurface = glm::any(glm::equal(glm::abs(point), upper));
                if (isOnSurface) continue;
                const bool isInside = glm::all(glm::lessThan(glm::abs(point), upper));
                EXPECT_EQ(accel.contains(point), isInside) << x << ' ' << y << ' ' << z;
            }
}

struct ClosedMeshCase {
    TestGeometry mesh;
    double scale;
    glm::dvec3 offset;
};

std::vector<ClosedMeshCase> closedMeshCases() {
    std::vector<ClosedMeshCase> cases;
    for (const TestGeometry& mesh :
         {icosphere(3, 0.0, 1), icosphere(4, 0.15, 3), needleSphere(4, 256), gridBox(8), cone(64)}) {
        for (const int exponent : {-60, -30, 0, 30, 60})
            cases.push_back({mesh, std::exp2(exponent), glm::dvec3(0.0)});
        for (const double offset : {1.0, 1e3, 1e6})
            cases.push_back({mesh, 1.0, {offset, -offset, 0.5 * offset}});
    }
    return cases;
}

/// A ray from outside, aimed at a vertex or a point of an edge.
Ray rayFromOutside(const TestGeometry& mesh, const ClosedMeshCase& placed, Random& random) {
    const auto triangle = static_cast<std::size_t>(random.integer(static_cast<int>(mesh.triangles.size())));
    const int k = random.integer(3);
    const glm::dvec3 a = mesh.corner(triangle, k), b = mesh.corner(triangle, (k + 1) % 3);
    const double along = random.integer(2) == 0 ? 0.0 : random.integer(65) / 64.0;
    // A dyadic origin on a sphere's scale makes many of the hits exact.
    glm::dvec3 from;
    do
        for (int axis = 0; axis < 3; ++axis) from[axis] = (random.integer(257) - 128) / 16.0;
    while (glm::length(from) < 2.0);
    Ray ray;
    ray.origin = glm::vec3(placed.offset + placed.scale * from);
    ray.direction = glm::vec3(a + along * (b - a) - glm::dvec3(ray.origin));
    return ray;
}

/// 40 cases with 25,000 rays each.
TEST(Crossings, ParityIsRightForRaysThroughEdgesAndVertices) {
    Random random(77);
    for (const ClosedMeshCase& placed : closedMeshCases()) {
        const TestGeometry mesh = placed.mesh.transformed(placed.scale, placed.offset);
        const Accel accel = Accel::build(mesh.input());
        const glm::vec3 inside(placed.offset + placed.scale * glm::dvec3(0.03125, 0.0625, 0.125));
        ASSERT_TRUE(accel.contains(inside)) << mesh.name << ", scale " << placed.scale;
        for (int i = 0; i < 12500; ++i) {
            Ray ray = rayFromOutside(mesh, placed, random);
            ASSERT_EQ(accel.countCrossings(ray) % 2, 0u)
                << mesh.name << ", scale " << placed.scale << ": " << text(ray);
            ray.direction += ray.origin - inside;  // to the same target
            ray.origin = inside;
            ASSERT_EQ(accel.countCrossings(ray) % 2, 1u)
                << mesh.name << ", scale " << placed.scale << ", from inside: " << text(ray);
        }
    }
}

}  // namespace
}  // namespace rayscope::test
