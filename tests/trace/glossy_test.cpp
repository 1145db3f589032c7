// Glossy reflection of a straight edge is a cumulative normal distribution.
#include "support/closed_forms.h"
#include "support/patterns.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

constexpr float kSigma = 1.0f, kShininess = 4.0f;
/// Standard deviation of the tangent plane's coordinates at distance 1: the deviates apply at distance 0.3.
double spread(double sigma, double shininess) { return sigma / (3.0 * shininess) / 0.3; }

/// A mirror in the plane z = 0, seen along the direction that is reflected along the z axis, under a
/// bright half-plane x > edge at height 2.
SceneDescription underStep(float edge, float shininess = kShininess) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.0f), Rgb(1.0f), shininess), material(Rgb(1.0f))};
    scene.meshes = {quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}),
                    quad({edge, -1e4f, 2}, {1e4f, 0, 0}, {0, 2e4f, 0}, 1)};
    scene.cameras = {pointCamera({0, 0, 1}, glm::vec3(0))};
    return scene;
}

Settings glossySettings(SamplePattern pattern, int samples, float sigma = kSigma) {
    Settings settings;
    settings.shading = false;
    settings.glossy = true;
    settings.glossySigma = sigma;
    settings.glossySamples = samples;
    settings.sampler = pattern;
    return settings;
}

/// The plane through the mirror's point and the edge has the normal (2, 0, −edge) / …; the reflection is ez.
double stepBrightness(double edge, double sigma = kSigma, double shininess = kShininess) {
    return normalCdf(-edge / 2.0 / spread(sigma, shininess));
}

TEST(GlossyReflection, BlursAStepEdgeToAnErrorFunction) {
    for (const float edge : {-0.6f, 0.25f, 0.6f})
        for (const SamplePattern pattern : kPatterns) {
            const auto world = compileScene(underStep(edge), glossySettings(pattern, 1024), 1, 1);
            const Estimate estimate =
                estimateOver(pattern == SamplePattern::Independent ? 1024 : 256,
                             [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1).x; });
            expectUnbiased(fmt::format("glossy step edge at {}, {}", edge, nameOf(pattern)), estimate,
                           stepBrightness(static_cast<double>(edge)));
        }
}

TEST(GlossyReflection, IsUnbiasedWithOneRayPerSample) {
    for (const SamplePattern pattern : kPatterns) {
        Settings settings = glossySettings(pattern, 1);
        settings.spp = 1024;
        const auto world = compileScene(underStep(0.25f), settings, 1, 1);
        const Estimate estimate =
            estimateOver(pattern == SamplePattern::Sobol ? 64 : 1024,
                         [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1024).x; });
        expectUnbiased(fmt::format("glossy step edge, single rays, {}", nameOf(pattern)), estimate,
                       stepBrightness(0.25));
    }
}

TEST(GlossyReflection, WidensWithSigmaAndNarrowsWithShininess) {
    for (const float sigma : {0.2f, 2.0f, 5.0f})
        for (const float shininess : {1.0f, 10.0f}) {
            const float edge =
                static_cast<float>(spread(static_cast<double>(sigma), static_cast<double>(shininess)));
            const auto world = compileScene(underStep(edge, shininess),
                                            glossySettings(SamplePattern::Sobol, 1024, sigma), 1, 1);
            const Estimate estimate =
                estimateOver(64, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1).x; });
            expectUnbiased(fmt::format("glossy step edge, sigma {}, shininess {}", sigma, shininess),
                           estimate, normalCdf(-0.5));
        }
}

TEST(GlossyReflection, CountsRaysBelowTheSurfaceAsZero) {
    // Everything above the mirror is white. At a grazing angle the result is the fraction of rays above the
    // surface.
    SceneDescription scene;
    scene.materials = {material(Rgb(0.0f), Rgb(1.0f), kShininess), material(Rgb(1.0f))};
    scene.meshes = {quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})};
    scene.spheres = {{"sky", {glm::vec3(0), 50.0f}, 1, glm::vec3(0)}};
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.0, 0.2));
    scene.cameras = {pointCamera(glm::vec3(glm::dvec3(-10.0, 0.0, 2.0)), glm::vec3(0))};
    const auto world = compileScene(scene, glossySettings(SamplePattern::Sobol, 1024), 1, 1);
    const double sine = std::sqrt(1.0 - direction.z * direction.z);
    const double exact = normalCdf(direction.z / (spread(kSigma, kShininess) * sine));
    const Estimate estimate =
        estimateOver(64, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1).x; });
    expectUnbiased("glossy rays above ground", estimate, exact);
    EventCounter counter;
    pixelMean(*world, 0, 0, 0, 1, counter);
    EXPECT_NEAR(counter.count(RayEnd::BelowSurface) / 1024.0, 1.0 - exact, 0.01);
    EXPECT_EQ(counter.count(RayKind::Glossy), 1024);
}

TEST(GlossyReflection, ConvergesAtTheRateOfItsSampler) {
    const double theory[] = {-0.5, -0.75, -0.75};
    static constexpr float kEdges[] = {-0.35f, -0.1f, 0.07f, 0.25f, 0.45f};
    for (const SamplePattern pattern : kPatterns) {
        const double slope = convergenceSlope(100, [&](int run, int n) {
            const float edge = kEdges[run % 5];
            const auto world = compileScene(underStep(edge), glossySettings(pattern, n), 1, 1);
            return pixelMean(*world, static_cast<std::uint64_t>(run), 0, 0, 1).x -
                   stepBrightness(static_cast<double>(edge));
        });
        expectSlope(fmt::format("glossy step edge, {}", nameOf(pattern)), slope,
                    theory[static_cast<int>(pattern)]);
    }
}

TEST(GlossyReflection, OfZeroWidthIsSpecularBitForBit) {
    const SceneDescription scene = underStep(-0.6f);
    Settings mirror = glossySettings(SamplePattern::Sobol, 64),
             sharp = glossySettings(SamplePattern::Sobol, 64, 0.0f);
    mirror.glossy = false;
    EventCounter a, b;
    EXPECT_EQ(pixelMean(*compileScene(scene, mirror, 1, 1), 0, 0, 0, 4, a),
              pixelMean(*compileScene(scene, sharp, 1, 1), 0, 0, 0, 4, b));
    EXPECT_EQ(a, b);
}

TEST(GlossyReflection, TracesGlossySamplesRaysAndSamplesOnceBehindThem) {
    SceneDescription scene = underStep(-50.0f);
    scene.materials[1] = material(Rgb(0.5f), Rgb(0.5f), kShininess);
    scene.lights = {
        {ParallelogramLight{
             {0, 0, 1}, {glm::vec3(0.1f, 0, 0), glm::vec3(0, 0.1f, 0)}, {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}},
         Falloff::None}};
    scene.cameras = {pointCamera({0.3f, 0, 1}, glm::vec3(0))};
    for (const int n : {1, 2, 64}) {
        Settings settings = glossySettings(SamplePattern::Sobol, n, 0.2f);
        settings.maxDepth = 2;
        settings.parallelogramSamples = 4;
        EventCounter counter;
        pixelMean(*compileScene(scene, settings, 1, 1), 0, 0, 0, 1, counter);
        EXPECT_EQ(counter.count(RayKind::Camera), 1);
        // The first reflection splits into n, each hits the upper plane and continues as one ray (n
        // without the split).
        EXPECT_EQ(counter.count(RayKind::Glossy), 2 * n);
        // The mirror itself takes 16 light samples; behind a split every vertex takes one.
        EXPECT_LE(counter.lightSamples(), n > 1 ? 16 + 2 * n : 48);
    }
}

}  // namespace
}  // namespace rayscope::test
