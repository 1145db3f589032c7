// Two parallel mirrors make a geometric series.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// A camera between mirrors at z = ±1, looking along the normal of one.
SceneDescription facingMirrors(const Rgb& kd, const Rgb& ks) {
    SceneDescription scene;
    scene.materials = {material(kd, ks, 10.0f)};
    scene.meshes = {quad({-5, -5, -1}, {10, 0, 0}, {0, 10, 0}), quad({-5, -5, 1}, {10, 0, 0}, {0, 10, 0})};
    scene.cameras = {pointCamera({0, 0, 0}, {0, 0, -1})};
    return scene;
}

double geometricSum(double first, double ratio, int terms) {
    return first * (1.0 - std::pow(ratio, terms)) / (1.0 - ratio);
}

TEST(Recursion, BetweenTwoMirrorsSumsAGeometricSeries) {
    const SceneDescription scene = facingMirrors(Rgb(0.25f), {0.5f, 0.75f, 0.875f});
    double worst = 0.0;
    for (int depth = 0; depth <= 16; ++depth) {
        Settings settings;
        settings.shading = false;
        settings.maxDepth = depth;
        EventCounter counter;
        const RgbSum measured = pixelMean(*compileScene(scene, settings, 1, 1), 0, 0, 0, 1, counter);
        EXPECT_EQ(counter.count(RayKind::Camera), 1);
        EXPECT_EQ(counter.count(RayKind::Reflection), depth);
        EXPECT_EQ(counter.count(RayEnd::DepthLimit), 1);
        const glm::dvec3 expected(geometricSum(0.25, 0.5, depth + 1), geometricSum(0.25, 0.75, depth + 1),
                                  geometricSum(0.25, 0.875, depth + 1));
        for (int c = 0; c < 3; ++c) updateWorst(worst, std::abs(measured[c] / expected[c] - 1.0));
    }
    EXPECT_LT(worst, 17 * 0x1p-52);
    reportDeviation("recursion, shading off", worst, "relative");
}

TEST(Recursion, AddsTheLocalColourOfEveryMirror) {
    // A light half-way between the mirrors illuminates both equally, so the series stays geometric.
    SceneDescription scene = facingMirrors(Rgb(0.5f), Rgb(0.75f));
    scene.lights = {pointLight({1, 0, 0})};
    const double cosine = 1.0 / std::sqrt(2.0);
    const double local = 0.5 * cosine + 0.75 * std::pow(cosine, 10.0);
    Settings settings;
    settings.maxDepth = 16;
    const double measured = firstSample(*compileScene(scene, settings, 1, 1)).x;
    EXPECT_NEAR(measured / geometricSum(local, 0.75, 17), 1.0, kFloatRounding);
    reportDeviation("recursion, with shading", std::abs(measured / geometricSum(local, 0.75, 17) - 1.0),
                    "relative");
}

TEST(Recursion, EndsAtSurfacesThatDoNotReflect) {
    SceneDescription scene = facingMirrors(Rgb(0.25f), Rgb(0.5f));
    scene.materials.push_back(material(Rgb(1.0f)));
    scene.meshes[1].materials = {1};
    Settings settings;
    settings.shading = false;
    settings.maxDepth = 16;
    EventCounter counter;
    const RgbSum measured = pixelMean(*compileScene(scene, settings, 1, 1), 0, 0, 0, 1, counter);
    EXPECT_EQ(counter.count(RayKind::Reflection), 1);
    EXPECT_EQ(counter.count(RayEnd::Absorbed), 1);
    EXPECT_EQ(measured, RgbSum(0.75));
    settings.recursion = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(0.25));
}

TEST(Recursion, ByIlluminationModelReflectsFromThreeOn) {
    Settings settings;
    settings.shading = false;
    settings.reflectWhen = ReflectWhen::Illum;
    settings.maxDepth = 1;
    for (const int illum : {-1, 0, 2, 3, 5, 9, 10}) {
        SceneDescription scene = facingMirrors(Rgb(0.25f), Rgb(0.5f));
        scene.materials[0].illum = illum;
        EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)),
                  RgbSum(illum >= 3 && illum <= 9 ? 0.375 : 0.25))
            << illum;
    }
}

TEST(Recursion, MirrorsAtTheAngleOfIncidence) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.0f), Rgb(1.0f)), material(Rgb(1.0f))};
    scene.meshes = {quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10})};
    // Via the floor: from (−3, 2, 0) over the origin to (3, 2, 0), a small target.
    scene.spheres = {{"target", {{3, 2, 0}, 1e-3f}, 1, glm::vec3(0)}};
    scene.cameras = {pointCamera({-3, 2, 0}, glm::vec3(0))};
    Settings settings;
    settings.shading = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(1.0));
    scene.spheres[0].sphere.center.y = 2.002f;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(0.0));
}

}  // namespace
}  // namespace rayscope::test
