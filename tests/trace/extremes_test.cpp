// Extreme parameters: finite results with the right limits.
#include <limits>

#include "math/vectors.h"
#include "support/all_effects_scene.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity(),
                kNan = std::numeric_limits<float>::quiet_NaN();

SceneDescription floorUnder(const Light& light, const Material& m = material(Rgb(0.5f), Rgb(0.3f), 10.0f)) {
    SceneDescription scene;
    scene.materials = {m};
    scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18})};
    scene.lights = {light};
    scene.cameras = {pointCamera({1, 3, 2}, glm::vec3(0))};
    return scene;
}

TEST(Extremes, LightsOfZeroSizeArePointLights) {
    const glm::vec3 at(0.5f, 2, 0.3f);
    const RgbSum point = firstSample(*compileScene(floorUnder(pointLight(at)), {}, 1, 1));
    const SegmentLight segment{{at, at}, {Rgb(1), Rgb(1)}};
    const ParallelogramLight nothing{at, {glm::vec3(0), glm::vec3(0)}, {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}};
    for (const Light& light : {Light{segment, Falloff::None}, Light{nothing, Falloff::None}})
        for (const LightSampleCount rule : {LightSampleCount::Fixed, LightSampleCount::PerLength}) {
            Settings settings;
            settings.lightSampleCount = rule;
            EXPECT_LT(glm::distance(firstSample(*compileScene(floorUnder(light), settings, 1, 1)), point),
                      1e-12);
        }
    // With one edge of zero length a parallelogram is a segment, with the same mean.
    const ParallelogramLight thin{at, {glm::vec3(1, 0, 0), glm::vec3(0)}, {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}};
    const SegmentLight same{{at, at + glm::vec3(1, 0, 0)}, {Rgb(1), Rgb(1)}};
    Settings many;
    many.segmentSamples = 1024;
    many.parallelogramSamples = 32;
    EXPECT_NEAR(firstSample(*compileScene(floorUnder({thin, Falloff::None}), many, 1, 1)).x,
                firstSample(*compileScene(floorUnder({same, Falloff::None}), many, 1, 1)).x, 1e-3);
}

TEST(Extremes, ALightOnTheSurfaceIsFinite) {
    for (const Falloff falloff : {Falloff::None, Falloff::InverseSquare})
        for (const float height : {0.0f, 1e-45f, 1e-30f, 1e-20f, 1e-7f, 1e20f, 1e38f})
            for (const bool shading : {true, false}) {
                Settings settings;
                settings.shading = shading;
                const Light light{PointLight{{0, height, 0}, Rgb(1.0f)}, falloff};
                const RgbSum value = firstSample(*compileScene(floorUnder(light), settings, 1, 1));
                EXPECT_TRUE(math::isFinite(value)) << height;
                EXPECT_GE(value.x, 0.0);
            }
}

/// Six faces of a box around a point.
std::vector<MeshInstance> boxAround(const glm::vec3& center, float half) {
    std::vector<MeshInstance> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-half, half}) {
            glm::vec3 corner = center - half, u(0.0f), v(0.0f);
            corner[axis] = center[axis] + side;
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2.0f * half;
            faces.push_back(quad(corner, u, v));
        }
    return faces;
}

TEST(Extremes, LightsInsideABoxIlluminateOnlyItsInside) {
    const glm::vec3 inside(0.25f, 2, -0.125f);
    const glm::vec3 u(0.25f, 0, 0), v(0, 0.125f, 0.25f);
    const Rgb white(1.0f);
    const std::vector<Light> lights = {
        pointLight(inside),
        {SegmentLight{{inside - u, inside + u}, {white, white}}, Falloff::None},
        {ParallelogramLight{inside - 0.5f * (u + v), {u, v}, {white, white, white, white}}, Falloff::None}};
    for (const bool box : {false, true})
        for (const Light& light : lights) {
            SceneDescription scene = floorUnder(light);
            EXPECT_GT(firstSample(*compileScene(scene, {}, 1, 1)).x, 0.1);
            if (box)
                for (const MeshInstance& face : boxAround(inside, 1.0f)) scene.meshes.push_back(face);
            else
                scene.spheres = {{"s", {inside, 1.0f}, 0, glm::vec3(0)}};
            for (int x = -8; x <= 8; ++x) {  // no light leaks, not even through an edge
                scene.cameras = {pointCamera({0.5f * static_cast<float>(x), 0.5f, 3}, {x, 0, 0})};
                EXPECT_EQ(firstSample(*compileScene(scene, {}, 1, 1)), RgbSum(0.0)) << x << ' ' << box;
            }
            // Seen from the light along the normal: kd + ks.
            scene.cameras = {pointCamera(inside, inside - glm::vec3(0, 1, 0))};
            Settings settings;
            settings.maxDepth = 0;
            const double value = firstSample(*compileScene(scene, settings, 1, 1)).x;
            EXPECT_NEAR(value, 0.8, &light == lights.data() ? 1e-6 : 0.1) << box;
        }
}

TEST(Extremes, ShininessHasTheRightLimits) {
    // The light is at the mirror image of the eye: the highlight is ks for every shininess.
    const Light mirrored = pointLight({-1, 3, -2});
    for (const float shininess : {0.0f, 1e-30f, 1.0f, 1e6f})
        EXPECT_NEAR(firstSample(*compileScene(floorUnder(mirrored, material(Rgb(0.0f), Rgb(0.3f), shininess)),
                                              {}, 1, 1))
                        .x,
                    static_cast<double>(0.3f), 1e-5)
            << shininess;
    const Light beside = pointLight({2, 3, -2});
    EXPECT_NEAR(
        firstSample(*compileScene(floorUnder(beside, material(Rgb(0.0f), Rgb(0.3f), 0.0f)), {}, 1, 1)).x,
        static_cast<double>(0.3f), 1e-12);
    EXPECT_EQ(
        firstSample(*compileScene(floorUnder(beside, material(Rgb(0.0f), Rgb(0.3f), 1e6f)), {}, 1, 1)).x,
        0.0);
    EXPECT_EQ(
        firstSample(*compileScene(floorUnder(beside, material(Rgb(0.0f), Rgb(0.3f), kInfinity)), {}, 1, 1)).x,
        0.0);
}

/// Glossy reflection in a floor inside a white sphere: the fraction of rays above the surface.
double glossyValue(float sigma, float shininess) {
    SceneDescription scene = floorUnder(pointLight({0, 1, 0}), material(Rgb(0.0f), Rgb(1.0f), shininess));
    scene.lights.clear();
    scene.materials.push_back(material(Rgb(1.0f)));
    scene.spheres = {{"sky", {glm::vec3(0), 50.0f}, 1, glm::vec3(0)}};
    scene.cameras = {pointCamera({4, 1.5f, 0.1f}, glm::vec3(0))};
    Settings settings;
    settings.shading = false;
    settings.glossy = true;
    settings.glossySigma = sigma;
    settings.glossySamples = 256;
    const RgbSum value = firstSample(*compileScene(scene, settings, 1, 1));
    EXPECT_TRUE(math::isFinite(value));
    return value.x;
}

TEST(Extremes, GlossyReflectionHasTheRightLimits) {
    const double mirror = glossyValue(0.0f, 10.0f);
    EXPECT_EQ(mirror, 1.0);
    for (const float sigma : {1e-45f, 1e-30f, 1e-10f, 1e-4f})
        EXPECT_NEAR(glossyValue(sigma, 10.0f), mirror, 1e-12);
    EXPECT_NEAR(glossyValue(100.0f, 1e6f), mirror, 1e-12);
    for (const float shininess : {0.0f, 1e-30f}) {
        // The widest lobe: half of the rays are below the surface.
        EXPECT_NEAR(glossyValue(100.0f, shininess), 0.5, 0.02);
    }
}

TEST(Extremes, ApertureSizesAreFinite) {
    SceneDescription scene = allEffectsScene();
    Settings settings;
    settings.lensSamples = 2;
    for (const float fNumber : {0.1f, 1.0f, 1000.0f, 1e30f})
        for (const float focus : {1e-6f, 1.0f, 1e9f, kInfinity})
            for (const float focal : {1e-30f, 0.05f, 100.0f}) {
                scene.cameras[0].lens = Lens{fNumber, focal, focus};
                const auto world = compileScene(scene, settings, 4, 4);
                for (int i = 0; i < 16; ++i)
                    EXPECT_TRUE(math::isFinite(pixelMean(*world, 0, i % 4, i / 4, 1)));
            }
    // A small enough aperture is a pinhole.
    scene.cameras[0].lens = Lens{1e30f, 0.05f, 2.0f};
    settings.lensSamples = 1;
    const auto closed = compileScene(scene, settings, 4, 4);
    scene.cameras[0].lens.reset();
    const auto pinhole = compileScene(scene, settings, 4, 4);
    for (int i = 0; i < 16; ++i)
        EXPECT_LT(
            glm::distance(pixelMean(*closed, 0, i % 4, i / 4, 1), pixelMean(*pinhole, 0, i % 4, i / 4, 1)),
            1e-3);
}

TEST(Extremes, NonFiniteTextureCoordinatesReadATexel) {
    for (const float odd : {kNan, kInfinity, -kInfinity, 1e30f, -1e-9f, 1.0f - 0x1p-24f})
        for (const TextureFilter filter :
             {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Mipmap}) {
            SceneDescription scene = allEffectsScene();
            auto sheet = std::make_shared<MeshData>(*scene.meshes[0].data);
            for (std::size_t i = 0; i < sheet->texCoords.size(); i += 3) sheet->texCoords[i].x = odd;
            scene.meshes[0].data = sheet;
            Settings settings;
            settings.textureFilter = filter;
            const auto world = compileScene(scene, settings, 8, 8);
            for (int i = 0; i < 64; ++i)
                ASSERT_TRUE(math::isFinite(pixelMean(*world, 0, i % 8, i / 8, 1))) << odd;
        }
}

TEST(Extremes, EmptyAndDegenerateScenesAreFinite) {
    SceneDescription empty;
    empty.cameras = {frontCamera(1.0f)};
    EXPECT_EQ(firstSample(*compileScene(empty, {}, 1, 1)), RgbSum(0.0));

    SceneDescription odd = allEffectsScene();
    auto sheet = std::make_shared<MeshData>(*odd.meshes[0].data);
    sheet->positions[5].x = kNan;
    sheet->positions[40].y = kInfinity;
    sheet->positions[60] = sheet->positions[61] = sheet->positions[62];
    odd.meshes[0].data = sheet;
    odd.spheres.push_back({"point", {{0, 0, 0.5f}, 0.0f}, 0, glm::vec3(0)});
    odd.spheres.push_back({"none", {{0, 0, 0.5f}, kNan}, 0, glm::vec3(0)});
    const auto world = compileScene(odd, {}, 12, 12);
    for (int i = 0; i < 144; ++i) ASSERT_TRUE(math::isFinite(pixelMean(*world, 0, i % 12, i / 12, 2)));
}

TEST(Extremes, TheImageIsInvariantUnderScaling) {
    // Everything is scaled by a power of two, so all roundings are the same except near the denormal numbers.
    std::vector<RgbSum> reference;
    for (const int exponent : {0, -20, 20}) {
        const float s = std::ldexp(1.0f, exponent);
        SceneDescription scene;
        scene.materials = {material(Rgb(0.5f), Rgb(0.3f), 10.0f)};
        scene.meshes = {quad(s * glm::vec3(-2, 0, 2), s * glm::vec3(4, 0, 0), s * glm::vec3(0, 0, -4))};
        scene.spheres = {{"s", {s * glm::vec3(0.1f, 0.4f, 0), s * 0.4f}, 0, glm::vec3(0)}};
        scene.lights = {pointLight(s * glm::vec3(1, 2, 1))};
        CameraDescription camera;
        camera.lookFrom = s * glm::vec3(0.5f, 1.5f, 2.5f);
        scene.cameras = {camera};
        const auto world = compileScene(scene, {}, 24, 24);
        std::vector<RgbSum> pixels;
        for (int i = 0; i < 576; ++i) pixels.push_back(pixelMean(*world, 0, i % 24, i / 24, 1));
        if (reference.empty()) reference = pixels;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            EXPECT_LT(glm::distance(pixels[i], reference[i]), 1e-5) << exponent << " " << i;
    }
}

}  // namespace
}  // namespace rayscope::test
