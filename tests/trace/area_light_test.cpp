// Segment and parallelogram lights against integrals known in closed form.
#include <set>

#include "support/closed_forms.h"
#include "support/patterns.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// The origin of a floor that faces up, under one light.
SceneDescription underLight(const Light& light) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18})};
    scene.lights = {light};
    scene.cameras = {pointCamera({1, 3, 2}, glm::vec3(0))};
    return scene;
}

Settings withSamples(SamplePattern pattern, int perSegment, int perSide) {
    Settings settings;
    settings.sampler = pattern;
    settings.segmentSamples = perSegment;
    settings.parallelogramSamples = perSide;
    return settings;
}

/// Unbiased for every pattern, with many samples of the light or of the pixel.
void expectUnbiasedForAll(const std::string& what, const SceneDescription& scene, double exact,
                          int perSegment, int perSide, int channel = 0) {
    for (const SamplePattern pattern : kPatterns) {
        for (const bool split : {true, false}) {
            Settings settings = withSamples(pattern, split ? perSegment : 1, split ? perSide : 1);
            const int spp = settings.spp = split ? 4 : 4 * perSegment;
            const auto world = compileScene(scene, settings, 1, 1);
            const Estimate estimate =
                estimateOver(pattern == SamplePattern::Independent ? 64 : 16,
                             [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, spp)[channel]; });
            expectUnbiased(fmt::format("{}, {}, {}", what, nameOf(pattern), split ? "split" : "single"),
                           estimate, exact);
        }
    }
}

const SegmentLight kSegment{{glm::vec3(-1, 0.5f, 0.3f), glm::vec3(2, 1.5f, -0.5f)},
                            {Rgb(1, 0, 0.5f), Rgb(1, 1, 0)}};

TEST(SegmentLight, HasTheAnalyticMean) {
    const SceneDescription scene = underLight({kSegment, Falloff::None});
    const glm::dvec3 n(0, 1, 0), a(kSegment.endpoints[0]), b(kSegment.endpoints[1]);
    expectUnbiasedForAll("segment light", scene, segmentMean(n, a, b, 1, 1), 1024, 1, 0);
    expectUnbiasedForAll("segment light, colour rising", scene, segmentMean(n, a, b, 0, 1), 2048, 1, 1);
    expectUnbiasedForAll("segment light, colour falling", scene, segmentMean(n, a, b, 0.5, 0), 2048, 1, 2);
}

TEST(SegmentLight, WithFalloffHasTheAnalyticMean) {
    const SceneDescription scene = underLight({kSegment, Falloff::InverseSquare});
    const double exact = segmentMeanInverseSquare({0, 1, 0}, glm::dvec3(kSegment.endpoints[0]),
                                                  glm::dvec3(kSegment.endpoints[1]));
    expectUnbiasedForAll("segment light, inverse square", scene, exact, 2048, 1);
}

ParallelogramLight rectangle(float x0, float x1, float z0, float z1, float height) {
    return {{x0, height, z0},
            {glm::vec3(x1 - x0, 0, 0), glm::vec3(0, 0, z1 - z0)},
            {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}};
}

TEST(ParallelogramLight, ParallelToTheReceiverHasTheAnalyticMean) {
    const SceneDescription scene = underLight({rectangle(-0.5f, 1.5f, -0.25f, 0.75f, 0.5f), Falloff::None});
    expectUnbiasedForAll("parallelogram light", scene, rectangleMean(-0.5, 1.5, -0.25, 0.75, 0.5), 1024, 32);
}

TEST(ParallelogramLight, WithFalloffHasItsSolidAngle) {
    const SceneDescription scene =
        underLight({rectangle(-0.5f, 1.5f, -0.25f, 0.75f, 0.5f), Falloff::InverseSquare});
    expectUnbiasedForAll("parallelogram light, inverse square", scene,
                         rectangleSolidAngle(-0.5, 1.5, -0.25, 0.75, 0.5) / 2.0, 2048, 46);
}

TEST(ParallelogramLight, SlantedWithFourColoursHasItsIntegral) {
    const ParallelogramLight light{{-1, 0.75f, -0.5f},
                                   {glm::vec3(2, 0.5f, 0.5f), glm::vec3(0.5f, 1, 1.5f)},
                                   {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1), Rgb(0, 1, 1)}};
    const SceneDescription scene = underLight({light, Falloff::None});
    for (int channel = 0; channel < 3; ++channel) {
        const double exact = integrateUnitSquare([&](double s, double t) {
            const glm::dvec3 p =
                glm::dvec3(light.corner) + s * glm::dvec3(light.edges[0]) + t * glm::dvec3(light.edges[1]);
            const double colors[3] = {(1 - s) * (1 - t), s,
                                      t};  // red at the corner; green and blue along the edges
            return colors[channel] * glm::normalize(p).y;
        });
        expectUnbiasedForAll(fmt::format("four-colour parallelogram light, channel {}", channel), scene,
                             exact, 2048, 46, channel);
    }
}

/// Error of the light samples of a single pixel sample.
double slopeOf(const Light& light, double exact, SamplePattern pattern) {
    const SceneDescription scene = underLight(light);
    return convergenceSlope(200, [&](int run, int n) {
        const int side = static_cast<int>(std::lround(std::sqrt(n)));
        const auto world = compileScene(scene, withSamples(pattern, n, side), 1, 1);
        return pixelMean(*world, static_cast<std::uint64_t>(run), 0, 0, 1).x - exact;
    });
}

TEST(SegmentLight, ConvergesAtTheRateOfItsSampler) {
    const double exact =
        segmentMean({0, 1, 0}, glm::dvec3(kSegment.endpoints[0]), glm::dvec3(kSegment.endpoints[1]), 1, 1);
    // One-dimensional and smooth: strata of width 1/n leave n^-3/2. Hash-based scrambling is not quite as
    // random as Owen's: over 2,000 runs its slope is -1.41.
    const double theory[] = {-0.5, -1.5, -1.41};
    for (const SamplePattern pattern : kPatterns)
        expectSlope(fmt::format("segment light, {}", nameOf(pattern)),
                    slopeOf({kSegment, Falloff::None}, exact, pattern), theory[static_cast<int>(pattern)]);
}

TEST(ParallelogramLight, ConvergesAtTheRateOfItsSampler) {
    const double exact = rectangleMean(-0.5, 1.5, -0.25, 0.75, 0.5);
    const double theory[] = {-0.5, -1.0, -1.39};  // the last one measured over 2,000 runs
    for (const SamplePattern pattern : kPatterns)
        expectSlope(fmt::format("parallelogram light, {}", nameOf(pattern)),
                    slopeOf({rectangle(-0.5f, 1.5f, -0.25f, 0.75f, 0.5f), Falloff::None}, exact, pattern),
                    theory[static_cast<int>(pattern)]);
}

/// A half-plane x < 0 at height h under a light of width a at height H makes a linear ramp of width
/// a h / (H − h) on the floor.
TEST(ParallelogramLight, HasAPenumbraThatIsALinearRamp) {
    constexpr double kWidth = 1.0, kHeight = 4.0, kBlocker = 1.0;
    SceneDescription scene = underLight({rectangle(-0.5f, 0.5f, -0.5f, 0.5f, 4.0f), Falloff::None});
    scene.meshes.push_back(quad({-9, 1, 9}, {9, 0, 0}, {0, 0, -18}));
    double worst = 0.0;
    for (const bool shading : {false, true}) {
        for (const double x : {-0.2, -0.1, 0.0, 0.05, 0.15, 0.2}) {
            scene.cameras = {
                pointCamera({static_cast<float>(x), 0.5f, 0.25f}, {static_cast<float>(x), 0, 0})};
            Settings settings = withSamples(SamplePattern::Sobol, 1, 64);
            settings.shading = shading;
            const auto world = compileScene(scene, settings, 1, 1);
            settings.softShadows = false;
            const auto lit = compileScene(scene, settings, 1, 1);
            // Visible are the points of the light to the right of the line through x and the edge.
            const double ramp = kWidth * kBlocker / (kHeight - kBlocker);
            const double exact = std::clamp(x / ramp + 0.5, 0.0, 1.0);
            const Estimate estimate =
                estimateOver(16, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1).x; });
            const double full = shading ? pixelMean(*lit, 0, 0, 0, 1).x : 1.0;
            if (!shading) {
                EXPECT_NEAR(estimate.mean, exact, 4.0 * estimate.standardError + 1e-6) << x;
                updateWorst(worst, std::abs(estimate.mean - exact));
            } else {
                // The visible part of the light is a rectangle.
                const double seen = 0.5 - exact;
                const double part =
                    exact > 0.0 ? exact * rectangleMean(seen - x, 0.5 - x, -0.5, 0.5, 4.0) : 0.0;
                EXPECT_NEAR(estimate.mean, part, 4.0 * estimate.standardError + 1e-6) << x;
                EXPECT_LE(estimate.mean, full + 1e-4);
            }
        }
    }
    reportDeviation("penumbra of a half-plane", worst, "absolute");
}

TEST(AreaLight, HardAndSoftShadowsAreIndependentSettings) {
    SceneDescription scene = underLight({rectangle(-0.5f, 0.5f, -0.5f, 0.5f, 4.0f), Falloff::None});
    scene.lights.push_back(pointLight({0, 4, 0}));
    scene.meshes.push_back(quad({-9, 1, 9}, {18, 0, 0}, {0, 0, -18}));
    scene.cameras = {pointCamera({0.5f, 0.5f, 0.5f}, glm::vec3(0))};
    Settings settings;
    settings.shading = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)).x, 0.0);
    settings.hardShadows = false;
    EXPECT_NEAR(firstSample(*compileScene(scene, settings, 1, 1)).x, 0.5, 1e-12);
    settings.softShadows = false;
    EXPECT_NEAR(firstSample(*compileScene(scene, settings, 1, 1)).x, 1.0, 1e-12);
}

int lightSamples(const Light& light, const Settings& settings) {
    EventCounter counter;
    pixelMean(*compileScene(underLight(light), settings, 1, 1), 0, 0, 0, 1, counter);
    return counter.lightSamples();
}

TEST(AreaLight, TakesTheNumberOfSamplesOfTheSettings) {
    const SegmentLight segment{{glm::vec3(0, 1, 0), glm::vec3(0, 1, 2.5f)}, {Rgb(1), Rgb(1)}};
    const Light wide{rectangle(0, 1.5f, 0, 0.3f, 1), Falloff::None};
    for (const int n : {1, 2, 7, 64}) {
        Settings settings = withSamples(SamplePattern::Sobol, n, n);
        EXPECT_EQ(lightSamples({segment, Falloff::None}, settings), n);
        EXPECT_EQ(lightSamples(wide, settings), n * n);
        settings.lightSampleCount = LightSampleCount::PerLength;
        EXPECT_EQ(lightSamples({segment, Falloff::None}, settings), static_cast<int>(std::floor(2.5 * n)));
        EXPECT_EQ(lightSamples(wide, settings), static_cast<int>(std::max(1.0, std::floor(1.5 * n)) *
                                                                 std::max(1.0, std::floor(0.3 * n + 1e-6))));
        EXPECT_EQ(lightSamples(pointLight({0, 1, 0}), settings), 1);
    }
}

TEST(AreaLight, StratifiesItsSamplesOverTheGrid) {
    const Light light{rectangle(0, 1, 0, 1, 1), Falloff::None};
    for (const SamplePattern pattern : {SamplePattern::Jittered, SamplePattern::Sobol}) {
        RecordingObserver record;
        pixelMean(*compileScene(underLight(light), withSamples(pattern, 1, 8), 1, 1), 0, 0, 0, 1, record);
        std::set<int> cells;
        for (const trace::LightConnection& c : record.lights)
            cells.insert(static_cast<int>(c.at.position.x * 8) * 8 + static_cast<int>(c.at.position.z * 8));
        EXPECT_EQ(cells.size(), 64u) << nameOf(pattern);
    }
}

}  // namespace
}  // namespace rayscope::test
