// The environment map behind all geometry, in mirrors, and as a reflection map.
#include "shading/environment_lookup.h"
#include "support/environments.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

SceneDescription skyOnly(std::shared_ptr<const Environment> environment) {
    SceneDescription scene;
    scene.environment = std::move(environment);
    return scene;
}

const glm::dvec3 kAxis = glm::normalize(glm::dvec3(0.3, 0.7, -0.4));

TEST(EnvironmentMap, OfAConstantIsTheConstantEverywhere) {
    const Rgb color(0.25f, 0.5f, 2.0f);
    for (const auto& environment : {cubeOf(8, [&](const glm::dvec3&) { return color; }),
                                    equirectOf(16, 8, [&](const glm::dvec3&) { return color; })}) {
        SceneDescription scene = skyOnly(environment);
        scene.cameras = {frontCamera(1.0f, 120.0f)};
        const auto world = compileScene(scene, {}, 24, 24);
        double worst = 0.0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x)
                updateWorst(worst, glm::distance(pixelMean(*world, 0, x, y, 4), RgbSum(color)));
        EXPECT_LT(worst, 1e-14);
        reportDeviation("environment, constant map", worst, "absolute");
    }
}

/// White furnace test: a surface with ks = 1 has the radiance of the constant environment around it.
TEST(EnvironmentMap, PassesTheFurnaceTest) {
    SceneDescription scene = skyOnly(cubeOf(4, [](const glm::dvec3&) { return Rgb(0.5f); }));
    scene.materials = {material(Rgb(0.0f), Rgb(1.0f), 8.0f, 0.6f)};
    scene.spheres = {{"s", {{0, 0, 0}, 1.0f}, 0, glm::vec3(0)},
                     {"t", {{0.5f, 0.5f, 1}, 0.5f}, 0, glm::vec3(0)}};
    Settings settings;
    settings.maxDepth = 16;
    const auto world = compileScene(scene, settings, 24, 24);
    int checked = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            EventCounter counter;
            const RgbSum value = pixelMean(*world, 0, x, y, 1, counter);
            if (counter.count(RayEnd::DepthLimit) > 0) continue;  // loses energy by design
            EXPECT_NEAR(value.x, 0.5, 1e-12);
            ++checked;
        }
    EXPECT_GT(checked, 200);
}

TEST(EnvironmentMap, IsLookedUpInTheDirectionOfTheRay) {
    const auto gradient = [](const glm::dvec3& d) {
        return Rgb(static_cast<float>(0.5 + 0.5 * glm::dot(d, kAxis)));
    };
    SceneDescription scene = skyOnly(cubeOf(128, gradient));
    double worst = 0.0;
    for (const glm::vec3& d :
         {glm::vec3(1, 0.2f, 0.1f), glm::vec3(-1, 0.5f, 0.9f), glm::vec3(0.1f, 1, 0.3f),
          glm::vec3(0.4f, -1, -0.6f), glm::vec3(-0.3f, 0.2f, 1), glm::vec3(0.7f, 0.7f, -1)}) {
        scene.cameras = {pointCamera(glm::vec3(0), d)};
        const double expected = 0.5 + 0.5 * glm::dot(glm::normalize(glm::dvec3(d)), kAxis);
        updateWorst(worst, std::abs(firstSample(*compileScene(scene, {}, 1, 1)).x - expected));
    }
    EXPECT_LT(worst, 1e-4);
    reportDeviation("environment, gradient on a cube of 128", worst, "absolute");
    Settings off;
    off.environment = false;
    EXPECT_EQ(firstSample(*compileScene(scene, off, 1, 1)), RgbSum(0.0));
}

TEST(EnvironmentMap, ReflectsAlongTheMirroredDirection) {
    const auto gradient = [](const glm::dvec3& d) {
        return Rgb(static_cast<float>(0.5 + 0.5 * glm::dot(d, kAxis)));
    };
    SceneDescription scene = skyOnly(equirectOf(512, 256, gradient));
    scene.materials = {material(Rgb(0.9f), Rgb(0.0f))};
    scene.spheres = {{"s", {{0, 0, 0}, 1.0f}, 0, glm::vec3(0)}};
    Settings settings;
    settings.reflectionMap = true;
    for (const glm::dvec2& p : {glm::dvec2(0.0, 0.0), glm::dvec2(0.5, 0.3), glm::dvec2(-0.6, 0.6)}) {
        const glm::dvec3 n(p.x, p.y, std::sqrt(1.0 - glm::dot(p, p)));
        scene.cameras = {pointCamera(glm::vec3(glm::dvec3(p.x, p.y, 5.0)), glm::vec3(n))};
        const glm::dvec3 in(0, 0, -1), out = in - 2.0 * glm::dot(in, n) * n;
        const double value = firstSample(*compileScene(scene, settings, 1, 1)).x;
        EXPECT_NEAR(value, 0.5 + 0.5 * glm::dot(out, kAxis), 1e-4);
        // A mirror with ks = 1 gives the same.
        SceneDescription mirrored = scene;
        mirrored.materials = {material(Rgb(0.0f), Rgb(1.0f))};
        EXPECT_NEAR(firstSample(*compileScene(mirrored, {}, 1, 1)).x, value, 1e-6);
    }
}

TEST(EnvironmentMap, IfMissingDisablesTheReflectionMap) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.5f))};
    scene.spheres = {{"s", {{0, 0, 0}, 1.0f}, 0, glm::vec3(0)}};
    scene.cameras = {pointCamera({0, 0, 5}, {0, 0, 1})};
    Settings settings;
    settings.shading = false;
    settings.reflectionMap = true;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(0.5));
}

}  // namespace
}  // namespace rayscope::test
