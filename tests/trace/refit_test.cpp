// A scene whose objects moved keeps its BVHs, refitted, until their SAH cost has grown too much.
#include <gtest/gtest.h>

#include "trace/compile.h"

namespace rayscope::test {
namespace {

/// The monkey, possibly transformed, and a sphere beside it.
std::shared_ptr<const SceneDescription> monkey(const Transform& transform) {
    Diagnostics notes;
    SceneDescription scene = loadScene("builtin:monkey", notes);
    scene.meshes[0].transform = transform;
    scene.spheres.push_back({"ball", {{3, 0, 0}, 0.5f}, 0});
    return std::make_shared<const SceneDescription>(std::move(scene));
}

Transform turned(float scale, const glm::vec3& angles) {
    Transform transform;
    transform.scale = scale;
    transform.rotate = angles;
    return transform;
}

std::shared_ptr<const trace::World> compiled(std::shared_ptr<const SceneDescription> scene,
                                             const Settings& settings, const trace::World* previous) {
    trace::CompileRequest request;
    request.camera = scene->cameras[0];
    request.scene = std::move(scene);
    request.settings = settings;
    return trace::compile(request, previous);
}

void expectSameHits(const trace::World& a, const trace::World& b) {
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const float x = static_cast<float>(i % 63) / 20.0f - 1.0f,
                    y = static_cast<float>(i / 63) / 32.0f - 1.0f;
        Hit first, second;
        const Ray ray{{x, y, 5.0f}, {0.1f * y, 0.05f * x, -1.0f}};
        ASSERT_EQ(a.closestHit(ray, 0.0f, first), b.closestHit(ray, 0.0f, second));
        ASSERT_EQ(first.t, second.t);
        ASSERT_EQ(first.primitive, second.primitive);
        hits += first.primitive != kNoPrimitive;
    }
    EXPECT_GT(hits, 500);
}

TEST(RefitWorld, RefitsAfterARotation) {
    const Settings settings;
    const auto before = compiled(monkey({}), settings, nullptr);
    EXPECT_EQ(before->buildReport.sahCostGrowth, 1.0);
    const auto scene = monkey(turned(1.1f, {0, 10, 3}));
    const auto moved = compiled(scene, settings, before.get()), fresh = compiled(scene, settings, nullptr);
    EXPECT_NE(moved->buildReport.sahCostGrowth, 1.0);
    EXPECT_LE(moved->buildReport.sahCostGrowth, static_cast<double>(settings.bvhRefit));
    EXPECT_EQ(fresh->buildReport.sahCostGrowth, 1.0);
    expectSameHits(*moved, *fresh);
    const auto again = compiled(scene, settings, moved.get());
    EXPECT_GT(moved->buildReport.seconds, 0.0);
    EXPECT_EQ(again->buildReport.seconds, moved->buildReport.seconds)
        << "the time of the BVHs that it shares";
    EXPECT_EQ(again->motionGroups[0].accel, moved->motionGroups[0].accel);
    EXPECT_EQ(again->buildReport.sahCostGrowth, moved->buildReport.sahCostGrowth);
}

TEST(RefitWorld, BuildsIfTheCostGrowsTooMuchOrBvhRefitIsZero) {
    Settings settings;
    const auto scene = monkey(turned(1.0f, {40, 30, 20}));
    for (const float most : {0.0f, 1.0f, 1000.0f}) {
        settings.bvhRefit = most;
        const auto before = compiled(monkey({}), settings, nullptr);
        const auto moved = compiled(scene, settings, before.get());
        EXPECT_EQ(moved->buildReport.sahCostGrowth > 1.0, most > 1.0f) << most;
        expectSameHits(*moved, *compiled(scene, settings, nullptr));
    }
}

TEST(RefitWorld, BuildsForOtherTriangles) {
    const auto before = compiled(monkey({}), {}, nullptr);
    SceneDescription other = *monkey({});
    auto mesh = std::make_shared<MeshData>(*other.meshes[0].data);
    std::swap(mesh->triangles.front(), mesh->triangles.back());
    other.meshes[0].data = mesh;
    EXPECT_EQ(
        compiled(std::make_shared<SceneDescription>(other), {}, before.get())->buildReport.sahCostGrowth,
        1.0);
    other.meshes.clear();
    EXPECT_EQ(
        compiled(std::make_shared<SceneDescription>(other), {}, before.get())->buildReport.sahCostGrowth,
        1.0);
}

}  // namespace
}  // namespace rayscope::test
