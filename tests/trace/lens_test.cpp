// Depth of field against the circle of confusion of a thin lens.
#include "support/closed_forms.h"
#include "support/patterns.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

constexpr double kFocal = 0.5, kFocus = 4.0, kNumber = 2.0, kAperture = kFocal / kNumber;

/// A camera at the origin, looking along −z at a white half-plane at the given depth whose edge is `x` to
/// the left of the central ray, through a lens that is focused on kFocus.
SceneDescription edgeAtDepth(float depth, float x) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {quad({-x, -99, -depth}, {99, 0, 0}, {0, 198, 0})};
    CameraDescription camera = pointCamera(glm::vec3(0), {0, 0, -1});
    camera.lens = Lens{static_cast<float>(kNumber), static_cast<float>(kFocal), static_cast<float>(kFocus)};
    scene.cameras = {camera};
    return scene;
}

Settings lensSettings(SamplePattern pattern, int samples, LensShape shape = LensShape::Disk) {
    Settings settings;
    settings.shading = false;
    settings.lensSamples = samples;
    settings.sampler = pattern;
    settings.lensShape = shape;
    return settings;
}

/// Radius, on the plane at depth d, of the pencil of rays of one pixel: similar triangles over the focus.
double blurRadius(double depth) { return 0.5 * kAperture * std::abs(depth - kFocus) / kFocus; }

double responseOf(LensShape shape, double t) {
    if (shape == LensShape::Square) return std::clamp(0.5 + 0.5 * t, 0.0, 1.0);
    return diskBelow(t);
}

void expectEdgeResponse(LensShape shape, float depth, double t, SamplePattern pattern, int runs) {
    const auto scene = edgeAtDepth(depth, static_cast<float>(t * blurRadius(static_cast<double>(depth))));
    const auto world = compileScene(scene, lensSettings(pattern, 512, shape), 1, 1);
    const Estimate estimate =
        estimateOver(runs, [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 1).x; });
    expectUnbiased(fmt::format("{} lens, edge at {}, depth {}, {}",
                               shape == LensShape::Disk ? "disk" : "square", t, depth, nameOf(pattern)),
                   estimate, responseOf(shape, t));
}

TEST(DepthOfField, BlursAnEdgeByTheShapeOfItsAperture) {
    for (const LensShape shape : {LensShape::Disk, LensShape::Square}) {
        for (const float depth : {2.0f, 10.0f})
            for (const double t : {-0.5, 0.0, 0.35})
                for (const SamplePattern pattern : {SamplePattern::Jittered, SamplePattern::Sobol})
                    expectEdgeResponse(shape, depth, t, pattern, 128);
        expectEdgeResponse(shape, 10.0f, 0.35, SamplePattern::Independent, 1024);
    }
}

TEST(DepthOfField, HasTheCircleOfConfusionOfAThinLens) {
    // On a sensor at f s / (s − f) behind the lens a point at depth d makes a disk of A |d − s| / d · f / (s
    // − f).
    double worst = 0.0;
    for (const float depth : {1.0f, 2.0f, 4.0f, 10.0f, 1000.0f}) {
        const auto world =
            compileScene(edgeAtDepth(depth, 50.0f), lensSettings(SamplePattern::Sobol, 512), 1, 1);
        RecordingObserver record;
        pixelMean(*world, 0, 0, 0, 8, record);
        double radius = 0.0;
        glm::dvec2 squares(0.0);
        for (const trace::Interaction& at : record.hits) {
            const glm::dvec2 p(at.position);
            radius = std::max(radius, glm::length(p));
            squares += p * p / static_cast<double>(record.hits.size());
        }
        const double d = static_cast<double>(depth), sensor = kFocal * kFocus / (kFocus - kFocal);
        const double measured = 2.0 * radius / d * sensor;
        const double expected = kAperture * std::abs(d - kFocus) / d * kFocal / (kFocus - kFocal);
        EXPECT_LE(measured, expected + 1e-6);
        EXPECT_NEAR(measured, expected,
                    2e-3 * expected + 1e-6);  // distance of the outermost of 4096 points from the rim
        const double variance = blurRadius(d) * blurRadius(d) / 4.0;
        EXPECT_NEAR(squares.x, variance, 2e-3 * variance + 1e-12);
        EXPECT_NEAR(squares.y, variance, 2e-3 * variance + 1e-12);
        if (expected > 0.0)
            updateWorst(worst, std::abs(std::sqrt(2.0 * (squares.x + squares.y)) / blurRadius(d) - 1.0));
    }
    reportDeviation("circle of confusion", worst, "relative");
}

TEST(DepthOfField, IsSharpInThePlaneOfFocus) {
    // Also off the axis: a plane, not a sphere.
    SceneDescription scene = edgeAtDepth(static_cast<float>(kFocus), 50.0f);
    scene.cameras[0].fov = 60.0f;
    const auto world = compileScene(scene, lensSettings(SamplePattern::Sobol, 64), 9, 9);
    double worst = 0.0;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) {
            RecordingObserver record;
            trace::radiance(*world, 0, {x, y, 0}, record);
            ASSERT_FALSE(record.hits.empty());
            for (const trace::Interaction& at : record.hits)
                updateWorst(worst, glm::distance(at.position, record.hits.front().position));
        }
    EXPECT_LT(worst, 8 * kFocus * 0x1p-23);
    reportDeviation("spread on the plane of focus", worst, "scene units");
}

TEST(DepthOfField, ConvergesAtTheRateOfItsSampler) {
    const double theory[] = {-0.5, -0.75, -0.75};
    static constexpr double kEdges[] = {-0.55, -0.2, 0.1, 0.35, 0.7};
    for (const SamplePattern pattern : kPatterns) {
        const double slope = convergenceSlope(100, [&](int run, int n) {
            const double t = kEdges[run % 5];
            const auto scene = edgeAtDepth(10.0f, static_cast<float>(t * blurRadius(10.0)));
            const auto world = compileScene(scene, lensSettings(pattern, n / 2), 1, 1);  // at most 512
            return pixelMean(*world, static_cast<std::uint64_t>(run), 0, 0, 1).x - diskBelow(t);
        });
        expectSlope(fmt::format("lens edge, {}", nameOf(pattern)), slope, theory[static_cast<int>(pattern)]);
    }
}

TEST(DepthOfField, IsUnbiasedWithOneRayPerSample) {
    const double t = 0.35;
    for (const SamplePattern pattern : kPatterns) {
        Settings settings = lensSettings(pattern, 1);
        settings.spp = 256;
        const auto world =
            compileScene(edgeAtDepth(10.0f, static_cast<float>(t * blurRadius(10.0))), settings, 1, 1);
        const Estimate estimate =
            estimateOver(pattern == SamplePattern::Independent ? 4096 : 256,
                         [&](std::uint64_t seed) { return pixelMean(*world, seed, 0, 0, 256).x; });
        expectUnbiased(fmt::format("lens edge, single rays, {}", nameOf(pattern)), estimate, diskBelow(t));
    }
}

TEST(DepthOfField, TracesLensSamplesRays) {
    for (const int n : {1, 2, 7, 512}) {
        EventCounter counter;
        pixelMean(*compileScene(edgeAtDepth(10.0f, 0.0f), lensSettings(SamplePattern::Sobol, n), 1, 1), 0, 0,
                  0, 3, counter);
        EXPECT_EQ(counter.count(RayKind::Camera), 3 * n);
    }
}

TEST(DepthOfField, OfAPointApertureIsThePinholeBitForBit) {
    SceneDescription scene = edgeAtDepth(10.0f, 0.01f);
    scene.cameras[0].fov = 40.0f;
    const auto image = [&](const SceneDescription& s, const Settings& settings) {
        std::vector<RgbSum> pixels;
        EventCounter counter;
        const auto world = compileScene(s, settings, 8, 8);
        for (int i = 0; i < 64; ++i) pixels.push_back(pixelMean(*world, 0, i % 8, i / 8, 4, counter));
        EXPECT_EQ(counter.count(RayKind::Camera), 256);
        return pixels;
    };
    Settings off = lensSettings(SamplePattern::Sobol, 64);
    off.depthOfField = false;
    const auto pinhole = image(scene, off);
    scene.cameras[0].lens->focalLength = 0.0f;
    EXPECT_EQ(image(scene, lensSettings(SamplePattern::Sobol, 64)), pinhole);
    scene.cameras[0].lens.reset();
    EXPECT_EQ(image(scene, lensSettings(SamplePattern::Sobol, 64)), pinhole);
}

TEST(DepthOfField, TracesThePinholeRayInTheSharpZone) {
    Settings settings = lensSettings(SamplePattern::Sobol, 16);
    for (const float zone : {0.0f, 0.9f, 1.1f}) {
        settings.sharpZone = zone;
        EventCounter counter;
        pixelMean(*compileScene(edgeAtDepth(5.0f, 0.01f), settings, 1, 1), 0, 0, 0, 1, counter);
        EXPECT_EQ(counter.count(RayKind::Camera), zone > 1.0f ? 1 : 16) << zone;
    }
}

}  // namespace
}  // namespace rayscope::test
