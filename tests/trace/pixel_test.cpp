// Pixel samples: the mean over a box of exactly one pixel.
#include "support/closed_forms.h"
#include "support/patterns.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

constexpr int kSize = 16;

/// A white half-plane beyond a slanted edge, in pixel coordinates: nx x + ny y < offset. Orthogonal enough to
/// count pixels: the camera looks straight at the plane.
struct SlantedEdge {
    glm::dvec2 normal = glm::normalize(glm::dvec2(0.8, 0.6));
    double offset = 9.3;
    SceneDescription scene;

    SlantedEdge() {
        // Pixel coordinates of a plane at distance 1 with tan(fov / 2) = 1/2: x = (X + 1/2) · size.
        const auto onPlane = [&](const glm::dvec2& pixel) {
            return glm::vec3(static_cast<float>(pixel.x / kSize - 0.5),
                             static_cast<float>(0.5 - pixel.y / kSize), 0);
        };
        const glm::dvec2 along(-normal.y, normal.x), foot = offset * normal;
        const glm::vec3 a = onPlane(foot - 99.0 * along), b = onPlane(foot + 99.0 * along);
        const glm::vec3 far = onPlane(foot - 99.0 * normal) - onPlane(foot);
        scene.materials = {material(Rgb(1.0f))};
        scene.meshes = {quad(a, b - a, far)};
        scene.cameras = {
            frontCamera(1.0f, static_cast<float>(2.0 * std::atan(0.5) * 180.0 / std::numbers::pi))};
    }
    double coverage(int x, int y) const { return halfPlaneInPixel(x, y, normal, offset); }
};

Settings edgeSettings(SamplePattern pattern, int spp) {
    Settings settings;
    settings.shading = false;
    settings.sampler = pattern;
    settings.spp = spp;
    return settings;
}

TEST(PixelSamples, OfASlantedEdgeHaveItsExactCoverage) {
    const SlantedEdge edge;
    for (const SamplePattern pattern : kPatterns) {
        constexpr int kSpp = 64, kRuns = 256;
        const auto world = compileScene(edge.scene, edgeSettings(pattern, kSpp), kSize, kSize);
        int partial = 0;
        double worst = 0.0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const double exact = edge.coverage(x, y);
                if (exact == 0.0 || exact == 1.0) {
                    EXPECT_EQ(pixelMean(*world, 0, x, y, kSpp).x, exact);
                    continue;
                }
                const Estimate estimate = estimateOver(
                    kRuns, [&](std::uint64_t seed) { return pixelMean(*world, seed, x, y, kSpp).x; });
                // About 20 pixels times three patterns: 5 standard errors allow for multiple testing.
                EXPECT_NEAR(estimate.mean, exact, 5.0 * estimate.standardError + 1e-5) << x << " " << y;
                updateWorst(worst, std::abs(estimate.mean - exact));
                ++partial;
            }
        }
        EXPECT_GE(partial, 16);
        reportDeviation(fmt::format("coverage of a slanted edge, {}", nameOf(pattern)), worst, "absolute");
    }
    constexpr int kSpp = 256;
    for (const SamplePattern pattern : kPatterns) {
        const auto world = compileScene(edge.scene, edgeSettings(pattern, kSpp), kSize, kSize);
        const Estimate estimate =
            estimateOver(pattern == SamplePattern::Independent ? 4096 : 512,
                         [&](std::uint64_t seed) { return pixelMean(*world, seed, 8, 4, kSpp).x; });
        expectUnbiased(fmt::format("one pixel of the edge, {}", nameOf(pattern)), estimate,
                       edge.coverage(8, 4));
    }
}

TEST(PixelSamples, ConvergeAtTheRateOfTheirSampler) {
    const SlantedEdge edge;
    const double theory[] = {-0.5, -0.75, -0.75};
    for (const SamplePattern pattern : kPatterns) {
        const double slope = convergenceSlope(100, [&](int run, int n) {
            const auto world = compileScene(edge.scene, edgeSettings(pattern, n), kSize, kSize);
            // The edge cuts each pixel differently.
            const int x = 7 + run % 5,
                      y = static_cast<int>((edge.offset - (x + 0.5) * edge.normal.x) / edge.normal.y);
            return pixelMean(*world, static_cast<std::uint64_t>(run), x, y, n).x - edge.coverage(x, y);
        });
        expectSlope(fmt::format("slanted edge, {}", nameOf(pattern)), slope,
                    theory[static_cast<int>(pattern)]);
    }
}

TEST(PixelSamples, FillExactlyOnePixel) {
    const SlantedEdge edge;
    for (const SamplePattern pattern : kPatterns) {
        constexpr int kSpp = 4096;
        const auto world = compileScene(edge.scene, edgeSettings(pattern, kSpp), kSize, kSize);
        RecordingObserver record;
        pixelMean(*world, 5, 3, 11, kSpp, record);
        ASSERT_EQ(record.segments.size(), std::size_t{kSpp});
        glm::dvec2 lowest(99.0), highest(0.0), mean(0.0), squares(0.0);
        for (const trace::Segment& s : record.segments) {
            const glm::dvec2 p =
                world->camera.project(glm::dvec3(s.ray.origin) + glm::dvec3(s.ray.direction)) -
                glm::dvec2(3.0, 11.0);
            lowest = glm::min(lowest, p), highest = glm::max(highest, p);
            mean += p / static_cast<double>(kSpp), squares += p * p / static_cast<double>(kSpp);
        }
        const double rounding = 1e-5;  // of the ray's direction, in pixels
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_GT(lowest[axis], -rounding);
            EXPECT_LT(lowest[axis], 0.01);
            EXPECT_LT(highest[axis], 1.0 + rounding);
            EXPECT_GT(highest[axis], 0.99);
            EXPECT_NEAR(mean[axis], 0.5, 4.0 / std::sqrt(12.0 * kSpp));
            EXPECT_NEAR(squares[axis] - mean[axis] * mean[axis], 1.0 / 12.0, 0.005);
        }
    }
}

TEST(PixelSamples, OfAJitteredGridFallOnePerCell) {
    const SlantedEdge edge;
    for (const int n : {2, 3, 5}) {
        const auto world =
            compileScene(edge.scene, edgeSettings(SamplePattern::Jittered, n * n), kSize, kSize);
        RecordingObserver record;
        pixelMean(*world, 5, 3, 11, n * n, record);
        std::vector<int> count(static_cast<std::size_t>(n * n), 0);
        for (const trace::Segment& s : record.segments) {
            const glm::dvec2 p =
                world->camera.project(glm::dvec3(s.ray.origin) + glm::dvec3(s.ray.direction)) -
                glm::dvec2(3.0, 11.0);
            ++count[static_cast<std::size_t>(static_cast<int>(p.y * n) * n + static_cast<int>(p.x * n))];
        }
        for (const int c : count) EXPECT_EQ(c, 1) << n;
    }
}

}  // namespace
}  // namespace rayscope::test
