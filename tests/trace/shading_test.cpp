// Phong shading at chosen points against an independent evaluation.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

const glm::vec3 kEye{1.0f, 2.0f, 4.0f};

/// Phong's formula with the reflected direction in textbook form, R = 2 (N·L) N − L.
glm::dvec3 byHand(const Material& m, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    const double nl = glm::dot(n, l);
    if (nl <= 0.0) return glm::dvec3(0.0);
    const double rv = std::max(0.0, glm::dot(2.0 * nl * n - l, v));
    return glm::dvec3(m.kd) * nl + glm::dvec3(m.ks) * std::pow(rv, static_cast<double>(m.shininess));
}

SceneDescription floorScene(const Material& m) {
    SceneDescription scene;
    scene.materials = {m};
    scene.meshes = {quad({-10, 0, 10}, {20, 0, 0}, {0, 0, -20})};
    return scene;
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

TEST(Shading, OfPointLightsIsPhongsModel) {
    double worst = 0.0;
    Settings settings;
    settings.recursion = false;
    for (const float shininess : {0.0f, 1.0f, 7.5f, 250.0f}) {
        const Material m = material({0.2f, 0.5f, 0.7f}, {0.6f, 0.3f, 0.1f}, shininess);
        for (const glm::vec3& at : {glm::vec3(0), glm::vec3(0.5f, 0, -1), glm::vec3(-2, 0, 0.3f)}) {
            SceneDescription scene = floorScene(m);
            const PointLight lights[] = {{{-1, 3, -2}, {0.9f, 0.8f, 0.7f}},
                                         {{2, 0.5f, 0}, {0.1f, 0.2f, 15.0f}}};
            for (const PointLight& light : lights) scene.lights.push_back({light, Falloff::None});
            scene.cameras = {pointCamera(kEye, at)};
            glm::dvec3 expected(0.0);
            const glm::dvec3 viewer = glm::normalize(glm::dvec3(kEye - at));
            for (const PointLight& light : lights)
                expected += glm::dvec3(light.color) *
                            byHand(m, {0, 1, 0}, glm::normalize(glm::dvec3(light.position - at)), viewer);
            const RgbSum measured = firstSample(*compileScene(scene, settings, 1, 1));
            updateWorst(worst, largest((measured - expected) / expected));
        }
    }
    EXPECT_LT(worst, 256 * kFloatRounding);  // the lobe amplifies direction errors by the shininess
    reportDeviation("shading, point lights", worst, "relative");
}

TEST(Shading, HasInverseSquareFalloffIfTheLightHas) {
    SceneDescription scene = floorScene(material(Rgb(1.0f)));
    scene.lights = {{PointLight{{0, 4, 0}, Rgb(1.0f)}, Falloff::InverseSquare}};
    scene.cameras = {pointCamera(kEye, glm::vec3(0))};
    EXPECT_NEAR(firstSample(*compileScene(scene, {}, 1, 1)).x, 1.0 / 16.0, kFloatRounding);
}

TEST(Shading, OfSegmentAndParallelogramLightsIsTheMeanOfPhongOverTheSamples) {
    const Material m = material({0.2f, 0.5f, 0.7f}, {0.6f, 0.3f, 0.1f}, 12.0f);
    SceneDescription scene = floorScene(m);
    const SegmentLight segment{{glm::vec3(-1, 2, 0), glm::vec3(1, 3, 1)}, {Rgb(1, 0, 0), Rgb(0, 1, 1)}};
    const ParallelogramLight area{{-1, 2, -1},
                                  {glm::vec3(1, 0, 0), glm::vec3(0.2f, 1, 1)},
                                  {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(0, 1, 1)}};
    scene.lights = {{segment, Falloff::None}, {area, Falloff::None}};
    scene.cameras = {pointCamera(kEye, glm::vec3(0))};
    Settings settings;
    settings.recursion = false;
    RecordingObserver record;
    const RgbSum measured = pixelMean(*compileScene(scene, settings, 1, 1), 3, 0, 0, 1, record);
    ASSERT_EQ(record.lights.size(), 16u + 16u);
    glm::dvec3 expected(0.0);
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(kEye));
    for (const trace::LightConnection& c : record.lights) {
        // The position of the sample on its light determines its colour.
        glm::dvec3 color;
        if (c.light == 0) {
            const double s = (c.at.position.x + 1.0) / 2.0;
            EXPECT_LT(glm::distance(c.at.position, glm::dvec3(-1.0 + 2.0 * s, 2.0 + s, s)), 1e-12);
            color = {1.0 - s, s, s};
        } else {
            const double t = c.at.position.y - 2.0, s = c.at.position.x + 1.0 - t * static_cast<double>(0.2f);
            EXPECT_LT(std::abs(c.at.position.z + 1.0 - t), 1e-12);
            ASSERT_TRUE(s >= 0.0 && s < 1.0 && t >= 0.0 && t < 1.0);
            color = {(1 - s) * (1 - t), s * (1 - t) + s * t, (1 - s) * t + s * t};
        }
        EXPECT_LT(glm::distance(c.at.color, color), 1e-12);
        expected += color * byHand(m, {0, 1, 0}, glm::normalize(c.at.position), viewer) / 16.0;
    }
    EXPECT_LT(largest((measured - expected) / expected), 16 * kFloatRounding);
    reportDeviation("shading, segment and parallelogram lights", largest((measured - expected) / expected),
                    "relative");
}

TEST(Shading, OnASphereFollowsItsNormal) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.spheres = {{"s", {{1, 0, 0}, 2.0f}, 0, glm::vec3(0)}};
    scene.lights = {pointLight({20, 5, 30})};
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 1, 3));
    const glm::dvec3 at = glm::dvec3(1, 0, 0) + 2.0 * n;
    scene.cameras = {pointCamera(glm::vec3(at + 3.0 * n), glm::vec3(at))};
    const double expected = glm::dot(n, glm::normalize(glm::dvec3(20, 5, 30) - at));
    EXPECT_NEAR(firstSample(*compileScene(scene, {}, 1, 1)).x, expected, 4 * kFloatRounding);
}

TEST(Shading, IsTheSameFromBehind) {
    SceneDescription scene = floorScene(material(Rgb(1.0f)));
    scene.lights = {pointLight({0, -4, 0})};
    scene.cameras = {pointCamera({1, -2, 1}, glm::vec3(0))};
    EXPECT_NEAR(firstSample(*compileScene(scene, {}, 1, 1)).x, 1.0, kFloatRounding);
    scene.lights = {pointLight({0, 4, 0})};  // behind the surface
    EXPECT_EQ(firstSample(*compileScene(scene, {}, 1, 1)), RgbSum(0.0));
}

TEST(Shading, OffIsTheDiffuseColourOfVisibleLights) {
    const Rgb kd(0.2f, 0.5f, 0.7f);
    SceneDescription scene = floorScene(material(kd, Rgb(0.0f)));
    scene.cameras = {pointCamera(kEye, glm::vec3(0))};
    Settings settings;
    settings.shading = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(kd));  // no lights at all

    scene.lights = {pointLight({0, 3, 0}), pointLight({3, 3, 0}, Rgb(9.0f))};
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(kd));
    scene.meshes.push_back(quad({0.5f, 1, -1}, {1, 0, 0}, {0, 0, 2}));  // occludes the second light
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), 0.5 * RgbSum(kd));
    settings.hardShadows = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(kd));
}

}  // namespace
}  // namespace rayscope::test
