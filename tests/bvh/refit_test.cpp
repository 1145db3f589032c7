// Refitted trees give the same hits as new ones.
#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>

#include <cstring>

#include "bvh/binary_tree.h"
#include "bvh/layout/wide_tree.h"
#include "bvh/meshes.h"
#include "bvh/traversal/traverse.h"
#include "support/non_finite.h"

namespace rayscope::test {
namespace {

std::vector<BuildSettings> variants() {
    std::vector<BuildSettings> all;
    for (const BvhBuilder builder : {BvhBuilder::Median, BvhBuilder::SahBinned, BvhBuilder::SahReinsertion})
        for (const BvhLayout layout : {BvhLayout::Binary, BvhLayout::Wide})
            for (const int maxLevel : {2, 64}) {
                BuildSettings settings;
                settings.builder = builder;
                settings.layout = layout;
                settings.maxLevel = maxLevel;
                settings.keepBinaryTree = true;
                all.push_back(settings);
            }
    return all;
}

/// Rotated, sheared and displaced at random; non-finite coordinates stay so.
TestGeometry moved(const TestGeometry& scene, std::uint64_t seed) {
    TestGeometry result = scene;
    Random random(seed);
    const auto shaken = [&](const glm::vec3& v) {
        return glm::vec3(v.y + 0.25f * v.x, -v.x, v.z) * (1.0f + 0.1f * random.inCube());
    };
    for (glm::vec3& vertex : result.vertices) vertex = shaken(vertex);
    for (Sphere& sphere : result.spheres) sphere.center = shaken(sphere.center);
    return result;
}

void expectSameHits(const Accel& accel, const TestGeometry& scene, std::uint64_t seed) {
    const std::vector<Ray> rays = edgeCaseRays(scene, 300, seed);
    std::vector<Hit> batch(rays.size());
    accel.closestHits(rays, batch);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hit expected, hit;
        const bool found = bvh::closestHitBruteForce(scene.input(), rays[i], expected);
        ASSERT_EQ(accel.closestHit(rays[i], hit), found) << scene.name << ": " << text(rays[i]);
        ASSERT_TRUE(sameHit(hit, expected)) << scene.name << ": " << text(rays[i]);
        ASSERT_TRUE(sameHit(batch[i], expected)) << scene.name << ": " << text(rays[i]);
        ASSERT_EQ(accel.anyHit(rays[i]), found) << scene.name << ": " << text(rays[i]);
    }
}

TEST(Refit, EqualsBruteForce) {
    for (const TestGeometry& scene : edgeCaseScenes())
        for (const BuildSettings& settings : variants()) {
            const TestGeometry first = moved(scene, 1), second = moved(first, 2);
            const Accel once = Accel::build(scene.input(), settings).refit(first.input());
            const Accel twice = once.refit(second.input());
            expectSameHits(once, first, 3);
            expectSameHits(twice, second, 4);
            if (HasFatalFailure()) return;
        }
}

/// Builders do not depend on the scale, so refit and build must be equal byte by byte.
TEST(Refit, TwiceTheSizeEqualsABuild) {
    TestGeometry scene = soup(20000, 0.05, 3);
    for (int i = 0; i < 50; ++i)
        scene.spheres.push_back({Random(static_cast<std::uint64_t>(i)).inCube(), 0.1f});
    TestGeometry larger = scene;
    for (glm::vec3& vertex : larger.vertices) vertex *= 2.0f;
    for (Sphere& sphere : larger.spheres) sphere = {sphere.center * 2.0f, sphere.radius * 2.0f};
    BuildSettings settings;
    settings.keepBinaryTree = true;
    const Accel fresh = Accel::build(larger.input(), settings);
    const Accel refit = Accel::build(scene.input(), settings).refit(larger.input());
    const auto same = [](const auto& a, const auto& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    };
    EXPECT_TRUE(same(refit.binaryTree()->nodes, fresh.binaryTree()->nodes));
    EXPECT_TRUE(std::ranges::equal(refit.wideTree()->nodes, fresh.wideTree()->nodes,
                                   [&](const bvh::kernel::WideNode& a, const bvh::kernel::WideNode& b) {
                                       return same(std::span(a.planes), std::span(b.planes)) &&
                                              same(std::span(a.child), std::span(b.child));
                                   }));
    EXPECT_TRUE(same(std::span(refit.wideTree()->blocks), std::span(fresh.wideTree()->blocks)));
    EXPECT_EQ(refit.wideTree()->maxCoordinate, fresh.wideTree()->maxCoordinate);
    EXPECT_EQ(refit.wideTree()->root, fresh.wideTree()->root);
    EXPECT_EQ(refit.bytes(), fresh.bytes());
    EXPECT_EQ(refit.summary().costGrowth, 1.0);
    EXPECT_EQ(fresh.summary().costGrowth, 1.0);
}

TEST(Refit, ReportsTheGrowthOfTheCost) {
    const TestGeometry scene = soup(5000, 0.05, 3);
    for (const BuildSettings& settings : variants()) {
        if (settings.maxLevel < 64) continue;
        const Accel built = Accel::build(scene.input(), settings);
        TestGeometry shaken = scene, scattered = scene;
        Random random(5);
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const glm::vec3 little = 0.1f * random.inCube(), far = random.inCube();
            for (int k = 0; k < 3; ++k) {
                shaken.vertices[scene.triangles[i][k]] += little;
                scattered.vertices[scene.triangles[i][k]] += far;
            }
        }
        const double small = built.refit(shaken.input()).summary().costGrowth,
                     large = built.refit(scattered.input()).summary().costGrowth;
        EXPECT_GT(small, 1.05);
        EXPECT_GT(large, 1.5 * small);
        EXPECT_NEAR(built.refit(scattered.input()).refit(scene.input()).summary().costGrowth, 1.0, 1e-9);
    }
}

TEST(Refit, RebuildsIfOtherTrianglesAreNotFinite) {
    const TestGeometry scene = soup(500, 0.3, 8);
    TestGeometry broken = scene, otherwise = scene;
    broken.vertices[scene.triangles[100].x].x = kNaN;
    broken.vertices[scene.triangles[300].y].z = kInfinity;
    otherwise.vertices[scene.triangles[20].z].y = kNaN;
    otherwise.vertices[scene.triangles[21].z].y = kNaN;
    for (const BuildSettings& settings : variants()) {
        const Accel whole = Accel::build(scene.input(), settings);
        const Accel refit = whole.refit(broken.input());
        EXPECT_EQ(refit.summary().droppedPrimitives, 2u);
        expectSameHits(refit, broken, 5);
        expectSameHits(refit.refit(otherwise.input()), otherwise, 6);  // as many, but not the same
        const Accel healed = refit.refit(scene.input());
        EXPECT_EQ(healed.summary().droppedPrimitives, 0u);
        expectSameHits(healed, scene, 7);
        if (HasFatalFailure()) return;
    }
}

TEST(Refit, MovedInPlace) {
    TestGeometry scene = soup(1000, 0.2, 12);
    const Accel before = Accel::build(scene.input());
    for (glm::vec3& vertex : scene.vertices) vertex = {vertex.z, vertex.x, -vertex.y};
    expectSameHits(before.refit(scene.input()), scene, 2);
}

TEST(Refit, EmptyAndSinglePrimitive) {
    EXPECT_FALSE(Accel().refit({}).anyHit({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_FALSE(Accel::build({}).refit({}).anyHit({{0, 0, 0}, {0, 0, 1}}));
    TestGeometry one;
    one.addTriangle({-1, -1, 0}, {2, -1, 0}, {-1, 2, 0});
    const Accel accel = Accel::build(one.input());
    for (glm::vec3& vertex : one.vertices) vertex += glm::vec3(0, 0, -5);
    Hit hit;
    ASSERT_TRUE(accel.refit(one.input()).closestHit({{0, 0, 1}, {0, 0, -1}}, hit));
    EXPECT_EQ(hit.t, 6.0f);
    const std::vector<Sphere> here{{{0, 0, 0}, 1.0f}}, elsewhere{{{0, 0, -8}, 2.0f}};
    const Accel sphere = Accel::build({{}, {}, here});
    ASSERT_TRUE(sphere.refit({{}, {}, elsewhere}).closestHit({{0, 0, 1}, {0, 0, -1}}, hit));
    EXPECT_EQ(hit.t, 7.0f);
}

TEST(Refit, RefusesOtherCounts) {
    const TestGeometry scene = soup(50, 0.2, 1), other = soup(51, 0.2, 1);
    const Accel accel = Accel::build(scene.input());
    EXPECT_THROW((void)accel.refit(other.input()), std::invalid_argument);
    EXPECT_THROW((void)accel.refit({}), std::invalid_argument);
    TestGeometry bad = scene;
    bad.triangles[7].y = 150;
    EXPECT_THROW((void)accel.refit(bad.input()), std::invalid_argument);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)accel.refit(scene.input(), stop.get_token()), Stopped);
}

}  // namespace
}  // namespace rayscope::test
