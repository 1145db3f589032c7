#include <rayscope/lab.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "bvh/intersect/hit_error.h"
#include "measure/lab/exact_crossing.h"
#include "measure/lab/lab_mesh.h"
#include "scene/generate/generate.h"
#include "support/expect_input_error.h"

namespace rayscope::test {
namespace {

SceneDescription sceneOf(MeshData data) {
    SceneDescription scene;
    scene.path = "test";
    scene.materials.emplace_back();
    scene.meshes.push_back(
        {.name = "mesh", .data = std::make_shared<MeshData>(std::move(data)), .materials = {0}});
    return scene;
}

LabResult quickLab(MeshData data, int rays, int threads = 0) {
    LabRequest request;
    request.scene = std::make_shared<SceneDescription>(sceneOf(std::move(data)));
    request.raysPerTestPoint = rays;
    request.quick = true;
    request.threads = threads;
    return runLab(request);
}

/// With small integers all products are exact in double.
TEST(ExactCrossing, AgreesWithIntegerArithmetic) {
    std::mt19937_64 random(1);
    const auto integer = [&](int range) {
        return static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range;
    };
    const auto point = [&](int range) { return glm::dvec3(integer(range), integer(range), integer(range)); };
    int crossed = 0, ties = 0;
    for (int i = 0; i < 30000; ++i) {
        const int range = random() % 2 ? 3 : 1000;
        const glm::dvec3 a = point(range), b = point(range), c = point(range), o = point(range),
                         d = point(range);
        if (d == glm::dvec3(0.0)) continue;
        const auto volume = [&](const glm::dvec3& p, const glm::dvec3& q) {
            return glm::dot(d, glm::cross(p - o, q - o));
        };
        const double u = volume(c, b), v = volume(a, c), w = volume(b, a), det = u + v + w;
        const measure::ExactCrossing exact({glm::vec3(o), glm::vec3(d)}, glm::vec3(a), glm::vec3(b),
                                           glm::vec3(c));
        ASSERT_EQ(exact.parallel, det == 0.0);
        if (det == 0.0) continue;
        if (u * v * w != 0.0) {
            ASSERT_EQ(exact.crossed, (u > 0.0) == (v > 0.0) && (v > 0.0) == (w > 0.0));
        } else {
            ++ties;
        }
        crossed += exact.crossed;
        const glm::dvec3 onRay = o + static_cast<double>(exact.t) * d;
        const glm::dvec3 onPlane =
            a + static_cast<double>(exact.u) * (b - a) + static_cast<double>(exact.v) * (c - a);
        ASSERT_LE(glm::length(onRay - onPlane), 1e-12 * (1.0 + glm::length(onRay)) * 1e3);
    }
    EXPECT_GT(crossed, 1000);
    EXPECT_GT(ties, 1000);
}

/// A line through a grid point of a triangulated plane crosses exactly one triangle.
TEST(ExactCrossing, BreaksTiesConsistently) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 direction(static_cast<int>(random() % 5) - 2, static_cast<int>(random() % 5) - 2,
                                  random() % 2 ? 1 : -1);
        const glm::vec3 target(static_cast<float>(random() % 5) / 2.0f - 1.0f,
                               static_cast<float>(random() % 5) / 2.0f - 1.0f, 0.0f);
        const Ray ray{target - 3.0f * direction, direction};
        int count = 0;
        for (int x = -3; x < 3; ++x)
            for (int y = -3; y < 3; ++y) {
                const glm::vec3 p(x, y, 0), q(x + 1, y, 0), r(x + 1, y + 1, 0), s(x, y + 1, 0);
                count += measure::ExactCrossing(ray, p, q, r).crossed;
                count += measure::ExactCrossing(ray, p, r, s).crossed;
            }
        ASSERT_EQ(count, 1);
    }
}

struct WorstRatio {
    double t = 0.0, weight = 0.0, edge = 0.0;
    int hits = 0;
};

/// Largest errors of the triangle test in double over their bounds. Edges are scaled by up to 2^`narrowest`,
/// and the distance of the hit point from an edge by up to 10^`aside`.
WorstRatio worstRatio(double narrowest, double aside, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> real(0.0, 1.0);
    const auto point = [&] { return glm::dvec3(real(random), real(random), real(random)) * 2.0 - 1.0; };
    WorstRatio worst;
    for (int i = 0; i < 60000; ++i) {
        const double size = std::exp2(120.0 * real(random) - 60.0);
        const glm::dvec3 at =
            random() % 2 ? size * std::pow(10.0, 4.0 * real(random)) * point() : glm::dvec3(0.0);
        const glm::vec3 a(at + size * point());
        const glm::vec3 b(glm::dvec3(a) + size * std::exp2(narrowest * real(random)) * point());
        const glm::vec3 c(glm::dvec3(a) + size * std::exp2(narrowest * real(random)) * point());
        const double u = real(random), v = (1.0 - u) * real(random) * std::pow(10.0, aside * real(random));
        const glm::dvec3 target =
            glm::dvec3(a) + u * (glm::dvec3(b) - glm::dvec3(a)) + v * (glm::dvec3(c) - glm::dvec3(a));
        Ray ray;
        ray.origin = glm::vec3(target + size * std::exp2(12.0 * real(random) - 6.0) * point());
        ray.direction = glm::vec3(target - glm::dvec3(ray.origin));
        if (ray.direction == glm::vec3(0.0f)) continue;
        const bvh::ShearedRay sheared(bvh::rayData(ray));
        bvh::TriangleHit hit;
        if (!bvh::intersectTriangle(sheared, a, b, c, hit)) continue;
        const measure::ExactCrossing exact(ray, a, b, c);
        if (exact.parallel || !exact.crossed) continue;
        const bvh::HitError error(sheared, a, b, c);
        const auto off = [](double value, long double right) {
            return static_cast<double>(std::abs(static_cast<long double>(value) - right));
        };
        worst.t = std::max(worst.t, off(hit.t, exact.t) / error.t);
        worst.weight =
            std::max({worst.weight, off(hit.u, exact.u) / error.weight, off(hit.v, exact.v) / error.weight});
        ++worst.hits;
    }
    return worst;
}

TEST(HitError, IsAnUpperBoundAndTight) {
    WorstRatio all;
    for (const auto& [narrowest, aside] : {std::pair{0.0, 0.0}, {-20.0, 0.0}, {-10.0, -9.0}, {-2.0, -3.0}}) {
        const WorstRatio worst = worstRatio(narrowest, aside, 7);
        EXPECT_LE(worst.t, 1.0);
        EXPECT_LE(worst.weight, 1.0);
        EXPECT_GT(worst.hits, 5000);
        all.t = std::max(all.t, worst.t);
        all.weight = std::max(all.weight, worst.weight);
    }
    EXPECT_GE(all.t, 0.01);
    EXPECT_GE(all.weight, 0.01);
    std::printf("error over bound: t %.3f, weights %.3f\n", all.t, all.weight);
    RecordProperty("worst t over bound", std::to_string(all.t));
    RecordProperty("worst weight over bound", std::to_string(all.weight));
}

TEST(Lab, RayscopePassesAndControlsFail) {
    const LabResult result = quickLab(scene::generate(scene::IcosphereShape{.subdivisions = 3}), 1500);
    EXPECT_EQ(result.testPoints.size(), 20u);
    EXPECT_EQ(result.triangles, 1280u);
    EXPECT_EQ(result.sharedEdges, 1920u);
    EXPECT_EQ(result.closedVertices, 642u);
    const LabRange& safe = result.range(LabMethod::Rayscope);
    EXPECT_EQ(safe.failingTestPoints, 0u);
    EXPECT_EQ(safe.lowestScale, -40);
    EXPECT_EQ(safe.highestScale, 40);
    EXPECT_EQ(safe.largestOffset, 1e7);
    EXPECT_FALSE(safe.failsBelow || safe.failsAbove || safe.failsBeyond);
    for (const LabMethod method : {LabMethod::Float, LabMethod::Epsilon, LabMethod::Double})
        EXPECT_GE(result.range(method).failingTestPoints, result.testPoints.size() / 2)
            << infoOf(method).name;
    double worst = 0.0;
    std::uint64_t sharedEdgeRays = 0, spawned = 0, offsetSurfaceRays = 0, floatLeaks = 0, floatLost = 0;
    for (const LabTestPoint& testPoint : result.testPoints) {
        const LabCounts& mine = testPoint.of(LabMethod::Rayscope);
        worst = std::max({worst, mine.tRatio, mine.weightRatio});
        sharedEdgeRays += mine.sharedEdgeRays, spawned += mine.spawned,
            offsetSurfaceRays += mine.offsetSurfaceRays;
        floatLeaks += testPoint.of(LabMethod::Float).leaks;
        floatLost += testPoint.of(LabMethod::Float).missedSurfaces;
        // A tolerance of 1e-6 rejects every triangle of a mesh that small.
        if (testPoint.transform.scale <= -20 && testPoint.transform.offset == 0.0) {
            EXPECT_EQ(testPoint.of(LabMethod::Epsilon).leaks,
                      testPoint.of(LabMethod::Epsilon).sharedEdgeRays);
        }
    }
    EXPECT_GT(worst, 0.5) << "results are rounded to float, so the bound is tight";
    EXPECT_GT(sharedEdgeRays, 15000u);
    EXPECT_GT(spawned, 8000u);
    EXPECT_GT(offsetSurfaceRays, 2000u);
    EXPECT_GT(floatLeaks, 100u);
    EXPECT_GT(floatLost, 100u);
}

/// A rotation by 90 or 180 degrees in double tilts a plane through the origin by about 1e-16.
TEST(Lab, PlanesRotatedByRightAnglesHaveNoSelfIntersections) {
    for (const glm::vec3& degrees : {glm::vec3(0, 180, 0), {90, 0, 0}, {0, 90, 180}, {180, 270, 90}}) {
        SceneDescription scene = sceneOf(scene::generate(scene::QuadShape{{1.4f, 1.0f}}));
        scene.meshes[0].transform.rotate = degrees;
        LabRequest request;
        request.scene = std::make_shared<SceneDescription>(scene);
        request.quick = true;
        request.raysPerTestPoint = 1000;
        EXPECT_EQ(runLab(request).range(LabMethod::Rayscope).failingTestPoints, 0u) << degrees.x;
    }
}

TEST(Lab, CountsDoNotDependOnThreads) {
    const LabResult one = quickLab(scene::generate(scene::BoxShape{}), 300, 1),
                    four = quickLab(scene::generate(scene::BoxShape{}), 300, 4);
    EXPECT_EQ(labCsv(one), labCsv(four));
    ASSERT_EQ(one.failures.size(), four.failures.size());
    for (std::size_t i = 0; i < one.failures.size(); ++i)
        EXPECT_EQ(std::memcmp(&one.failures[i].ray, &four.failures[i].ray, sizeof(Ray)), 0);
}

TEST(Lab, CountsDegenerateTriangles) {
    const LabResult result = quickLab(scene::generate(scene::IcosphereShape{.subdivisions = 4}), 50);
    EXPECT_EQ(result.meshOffset, 1e4);
    for (const LabTestPoint& testPoint : result.testPoints)
        EXPECT_EQ(testPoint.degenerate > 0, testPoint.transform.offset > 1e4);
}

TEST(Lab, AcceptsDegenerateAndNonFiniteMeshes) {
    MeshData one{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
    const LabResult single = quickLab(one, 200);
    EXPECT_EQ(single.sharedEdges, 0u);
    EXPECT_EQ(single.range(LabMethod::Rayscope).failingTestPoints, 0u);
    EXPECT_NE(labText(single).find("no edge is shared"), std::string::npos);
    EXPECT_EQ(labHtml(single).find("nan"), std::string::npos) << "fractions of no rays are gaps";

    MeshData odd = scene::generate(scene::IcosphereShape{.subdivisions = 2});
    odd.positions[3].x = std::nanf("");
    odd.positions[40] = odd.positions[41];
    odd.triangles.insert(odd.triangles.end(), {{7, 7, 9}, {10, 11, 12}, {10, 11, 12}});
    EXPECT_EQ(quickLab(odd, 200).range(LabMethod::Rayscope).failingTestPoints, 0u);

    MeshData huge = scene::generate(scene::BoxShape{});
    for (glm::vec3& p : huge.positions) p *= 1e24f;  // overflows when scaled by 2^40 or moved
    EXPECT_EQ(quickLab(huge, 100).range(LabMethod::Rayscope).failingTestPoints, 0u);

    LabRequest nothing;
    nothing.scene = std::make_shared<SceneDescription>();
    EXPECT_NE(inputErrorOf([&] { runLab(nothing); }).find("needs triangles"), std::string::npos);
}

TEST(Lab, KeepsResultsAfterAStop) {
    std::stop_source stop;
    LabRequest request;
    request.scene = std::make_shared<SceneDescription>(sceneOf(scene::generate(scene::BoxShape{})));
    request.raysPerTestPoint = 100;
    request.stop = stop.get_token();
    int calls = 0;
    request.progress = [&](double fraction, double remaining) {
        EXPECT_GE(remaining, 0.0);
        EXPECT_LE(fraction, 1.0);
        if (++calls == 4) stop.request_stop();
    };
    const LabResult result = runLab(request);
    EXPECT_TRUE(result.interrupted);
    ASSERT_EQ(result.testPoints.size(), 3u);
    EXPECT_TRUE(result.range(LabMethod::Rayscope).soundUntransformed)
        << "the untransformed scene comes first";
    EXPECT_FALSE(labHtml(result).empty());
    EXPECT_TRUE(nlohmann::json::parse(labJson(result))["interrupted"]);
}

TEST(Lab, ShapesHaveClosedVertices) {
    const measure::LabMesh mesh(labShapes());
    EXPECT_GT(mesh.closedVertices().size(), 5000u);
    EXPECT_GT(mesh.edges().size(), 15000u);
    for (const std::uint32_t vertex : mesh.closedVertices())
        ASSERT_GE(mesh.trianglesAround(vertex).size(), 3u);
}

}  // namespace
}  // namespace rayscope::test
