// Settings of effects that the scene does not use change neither bits nor events.
#include <gtest/gtest.h>

#include "support/all_effects_scene.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

struct Trace {
    std::vector<RgbSum> pixels;
    EventCounter events;
    std::uint64_t rays = 0;
    bool operator==(const Trace&) const = default;
};
Trace traceAll(const SceneDescription& scene, const Settings& settings, int size, int samples) {
    const auto world = compileScene(scene, settings, size, size);
    Trace trace;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int i = 0; i < samples; ++i) {
                const trace::SampleResult result = trace::radiance(*world, 3, {x, y, i}, trace.events);
                trace.pixels.push_back(result.radiance);
                trace.rays += result.rays;
            }
    return trace;
}

/// A diffuse, opaque, untextured, static floor without vertex normals under one light, seen by a pinhole
/// camera.
SceneDescription bareScene(const Light& light) {
    SceneDescription scene;
    scene.materials = {material({0.2f, 0.4f, 0.6f})};
    scene.meshes = {quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}),
                    quad({-0.5f, 0.5f, 0.5f}, {1, 0, 0}, {0, 0, -1})};
    scene.lights = {light};
    CameraDescription camera;
    camera.lookFrom = {0.5f, 2, 3};
    scene.cameras = {camera};
    return scene;
}

struct Change {
    const char *key, *from, *to;
};
void expectNoDifference(const SceneDescription& scene, std::initializer_list<Change> changes) {
    for (const Change& change : changes) {
        Settings a, b;
        for (Settings* s : {&a, &b}) s->glossy = true;  // a prerequisite of glossy_sigma and others
        assign(a, change.key, change.from);
        assign(b, change.key, change.to);
        EXPECT_EQ(traceAll(scene, a, 16, 4), traceAll(scene, b, 16, 4)) << change.key;
    }
}

TEST(UnusedSettings, OfEffectsCostNothing) {
    expectNoDifference(bareScene(pointLight({1, 3, 1})), {{"recursion", "false", "true"},
                                                          {"max_depth", "0", "16"},
                                                          {"reflect_when", "ks", "illum"},
                                                          {"glossy", "false", "true"},
                                                          {"glossy_sigma", "0", "5"},
                                                          {"glossy_samples", "1", "4096"},
                                                          {"soft_shadows", "false", "true"},
                                                          {"segment_samples", "1", "4096"},
                                                          {"parallelogram_samples", "1", "100"},
                                                          {"light_sample_count", "fixed", "per_length"},
                                                          {"transparency", "false", "true"},
                                                          {"transparent_shadows", "false", "true"},
                                                          {"normal_interpolation", "false", "true"},
                                                          {"texture_mapping", "false", "true"},
                                                          {"texture_filter", "nearest", "mipmap"},
                                                          {"environment", "false", "true"},
                                                          {"reflection_map", "false", "true"},
                                                          {"depth_of_field", "false", "true"},
                                                          {"lens_samples", "1", "512"},
                                                          {"lens_shape", "disk", "hexagon"},
                                                          {"sharp_zone", "0", "100"},
                                                          {"motion_blur", "false", "true"}});
}

TEST(UnusedSettings, OfHardShadowsCostNothingWithoutPointLights) {
    const ParallelogramLight area{
        {-1, 3, -1}, {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}, {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}};
    expectNoDifference(bareScene({area, Falloff::None}),
                       {{"hard_shadows", "false", "true"}, {"segment_samples", "1", "64"}});
}

TEST(UnusedSettings, ControlDetectsADifference) {
    const SceneDescription scene = bareScene(pointLight({1, 3, 1}));
    Settings off;
    off.hardShadows = false;
    const Trace with = traceAll(scene, {}, 16, 4), without = traceAll(scene, off, 16, 4);
    EXPECT_NE(with.pixels, without.pixels);
    EXPECT_FALSE(with.events == without.events);
    EXPECT_GT(with.rays, without.rays);
}

TEST(AllEffects, TogetherAreFinite) {
    for (const bool reflectionMap : {false, true})
        for (const SamplePattern pattern :
             {SamplePattern::Independent, SamplePattern::Jittered, SamplePattern::Sobol}) {
            Settings settings;
            settings.glossy = true;
            settings.glossySamples = 4;
            settings.lensSamples = 2;
            settings.transparentShadows = true;
            settings.textureFilter = TextureFilter::Mipmap;
            settings.reflectionMap = reflectionMap;
            settings.sampler = pattern;
            const Trace trace = traceAll(allEffectsScene(), settings, 24, 4);
            for (const RgbSum& value : trace.pixels) {
                ASSERT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z));
                ASSERT_GE(std::min({value.x, value.y, value.z}), 0.0);
            }
            if (reflectionMap) continue;
            for (const RayKind kind : {RayKind::Camera, RayKind::Glossy, RayKind::Transparent})
                EXPECT_GT(trace.events.count(kind), 0);
            for (const int count : trace.events.lights) EXPECT_GT(count, 0);
        }
}

}  // namespace
}  // namespace rayscope::test
