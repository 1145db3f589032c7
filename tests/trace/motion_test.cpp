// Motion blur: the mean over the time of the shutter.
#include "support/patterns.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// A white half-plane with its edge at x at the start, moving to the left by 1; and a sphere beside it.
SceneDescription movingEdge(float x) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {quad({x, -9, 0}, {9, 0, 0}, {0, 18, 0})};
    scene.meshes[0].motion = {-1, 0, 0};
    scene.cameras = {pointCamera({0, 0, 3}, glm::vec3(0))};
    return scene;
}

Settings motionSettings(SamplePattern pattern, int spp) {
    Settings settings;
    settings.shading = false;
    settings.sampler = pattern;
    settings.spp = spp;
    return settings;
}

TEST(MotionBlur, OfAnEdgeIsABoxFilter) {
    for (const float x : {-0.5f, 0.2347f, 0.618f, 1.5f})
        for (const SamplePattern pattern : kPatterns) {
            constexpr int kSpp = 256;
            const auto world = compileScene(movingEdge(x), motionSettings(pattern, kSpp), 1, 1);
            const double exact = std::clamp(1.0 - static_cast<double>(x), 0.0, 1.0);
            const Estimate estimate =
                estimateOver(pattern == SamplePattern::Independent ? 2048 : 128,
                             [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, kSpp).x; });
            if (exact > 0.0)
                expectUnbiased(fmt::format("moving edge at {}, {}", x, nameOf(pattern)), estimate, exact);
            else
                EXPECT_EQ(estimate.mean, 0.0);
        }
}

TEST(MotionBlur, OfASphereIsTheTimeForWhichItCoversThePoint) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    // Passes with its centre 0.3 above the line of sight: the chord is 0.8 of a displacement of 2.
    scene.spheres = {{"s", {{-1, 0.3f, 0}, 0.5f}, 0, glm::vec3(2, 0, 0)}};
    scene.cameras = {pointCamera({0, 0, 3}, glm::vec3(0))};
    const auto world = compileScene(scene, motionSettings(SamplePattern::Sobol, 1024), 1, 1);
    // The line of sight is a straight line through the origin along z: the sphere covers it while the
    // distance of its centre from that line is below the radius.
    const double chord = 2.0 * std::sqrt(0.25 - std::pow(static_cast<double>(0.3f), 2.0));
    const Estimate estimate =
        estimateOver(64, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1024).x; });
    expectUnbiased("moving sphere", estimate, chord / 2.0);
}

TEST(MotionBlur, ConvergesAtTheRateOfItsSampler) {
    // A step in one dimension: strata of width 1/n leave an error of at most one of them.
    const double theory[] = {-0.5, -1.0, -1.0};
    static constexpr float kEdges[] = {0.2347f, 0.3333f, 0.4142f, 0.618f, 0.7101f};
    for (const SamplePattern pattern : kPatterns) {
        const double slope = convergenceSlope(100, [&](int run, int n) {
            const float x = kEdges[run % 5];
            const auto world = compileScene(movingEdge(x), motionSettings(pattern, n), 1, 1);
            return pixelMean(*world, static_cast<std::uint64_t>(run), 0, 0, n).x -
                   (1.0 - static_cast<double>(x));
        });
        expectSlope(fmt::format("moving edge, {}", nameOf(pattern)), slope,
                    theory[static_cast<int>(pattern)]);
    }
}

TEST(MotionBlur, CastsMovingShadowsAndReflections) {
    // An occluder passes between the floor and the light during a quarter of the time.
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f)), material(Rgb(0.0f))};
    scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
                    quad({-0.75f, 1, 1}, {0.5f, 0, 0}, {0, 0, -2}, 1)};
    scene.meshes[1].motion = {2, 0, 0};
    scene.lights = {pointLight({0, 1e4f, 0})};
    scene.cameras = {pointCamera({1, 0.5f, 0}, glm::vec3(0))};
    const auto world = compileScene(scene, motionSettings(SamplePattern::Sobol, 1024), 1, 1);
    const Estimate estimate =
        estimateOver(64, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1024).x; });
    expectUnbiased("shadow of a moving blocker", estimate, 0.75);
}

TEST(MotionBlur, OffShowsTheStartOfTheShutter) {
    for (const float x : {-0.01f, 0.01f}) {
        Settings settings = motionSettings(SamplePattern::Sobol, 16);
        settings.motionBlur = false;
        EXPECT_EQ(pixelMean(*compileScene(movingEdge(x), settings, 1, 1), 0, 0, 0, 16).x,
                  x < 0.0f ? 1.0 : 0.0);
    }
}

TEST(MotionBlur, CausesNoSelfIntersection) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {quad({-900, 0, 900}, {1800, 0, 0}, {0, 0, -1800})};
    scene.meshes[0].motion = {123.4f, 0, 77.7f};
    scene.spheres = {{"s", {{3, 0.5f, 3}, 0.3f}, 0, glm::vec3(-100, 3, 7)}};
    scene.lights = {pointLight({10, 20, 30})};
    CameraDescription camera = frontCamera(3.0f);
    camera.lookFrom = {0, 4, 9};
    scene.cameras = {camera};
    const auto world = compileScene(scene, {}, 32, 32);
    EventCounter counter;
    for (int i = 0; i < 1024; ++i) pixelMean(*world, 0, i % 32, i / 32, 4, counter);
    const int occluded = counter.lights[static_cast<int>(Visibility::Occluded)];
    EXPECT_LT(occluded, counter.lightSamples() / 20);  // the fraction that the small sphere may occlude
    EXPECT_GT(counter.lightSamples(), 2000);
}

}  // namespace
}  // namespace rayscope::test
