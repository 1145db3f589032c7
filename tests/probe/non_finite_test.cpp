#include "probe/non_finite.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/environments.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::numeric_limits<float>::quiet_NaN();

SceneDescription litWall() {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.5f))};
    scene.meshes = {quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})};
    scene.lights = {pointLight({0, 0, 2}), pointLight({0, 1, 2})};
    scene.cameras = {pointCamera({0.1f, 0.2f, 3}, {0.1f, 0.2f, 0})};
    return scene;
}

std::string causeOf(const SceneDescription& scene) {
    const auto world = compileScene(scene, {}, 1, 1);
    return probe::causeOfNonFinite(probeSample(*world, 0, {0, 0, 0}), *world);
}

TEST(NonFinite, FiniteSampleHasNoCause) { EXPECT_THAT(causeOf(litWall()), IsEmpty()); }

TEST(NonFinite, NamesTheLight) {
    SceneDescription scene = litWall();
    std::get<PointLight>(scene.lights[1].shape).color = {0, kInfinity, 0};
    EXPECT_EQ(causeOf(scene),
              "where camera ray 0 hits mesh 0 'quad': light 2, sample 0 has the colour (0 inf 0)");
}

TEST(NonFinite, NamesTheMaterial) {
    SceneDescription scene = litWall();
    scene.materials[0].kd.y = kNan;
    EXPECT_THAT(causeOf(scene), HasSubstr("hits mesh 0 'quad': the diffuse colour is (0.5 nan 0.5)"));
}

TEST(NonFinite, NamesTheEnvironmentAndTheRay) {
    SceneDescription scene = litWall();
    scene.materials[0].ks = Rgb(1.0f);
    scene.environment = cubeOf(2, [](const glm::dvec3&) { return Rgb(kInfinity, 1.0f, 1.0f); });
    EXPECT_EQ(causeOf(scene), "on reflection ray 1: the environment adds (inf 1 1)");
}

TEST(NonFinite, DescribesOverflowingSums) {
    SceneDescription scene = litWall();
    scene.materials[0].kd = Rgb(1.0f);
    for (Light& light : scene.lights) std::get<PointLight>(light.shape).color = Rgb(3e38f, 0, 0);
    EXPECT_THAT(causeOf(scene), HasSubstr("the sum of its 2 terms is ("));
    EXPECT_THAT(causeOf(scene), HasSubstr("exceeds the range of float"));
}

}  // namespace
}  // namespace rayscope::test
