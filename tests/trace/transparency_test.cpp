// Transparent layers against the product formula.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// Layers of the given opacities and grey colours at z = 0, −1, −2 …, seen from the front.
SceneDescription stack(const std::vector<float>& opacities, const std::vector<float>& greys) {
    SceneDescription scene;
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        scene.materials.push_back(material(Rgb(greys[i]), Rgb(0.0f), 1.0f, opacities[i]));
        scene.meshes.push_back(
            quad({-1, -1, -static_cast<float>(i)}, {2, 0, 0}, {0, 2, 0}, static_cast<std::uint32_t>(i)));
    }
    scene.cameras = {pointCamera({0.1f, 0.2f, 3}, {0.1f, 0.2f, 0})};
    return scene;
}

Settings flat() {
    Settings settings;
    settings.shading = false;
    return settings;
}

TEST(Transparency, BlendsLayersByTheProductFormula) {
    const std::vector<float> opacities{0.25f, 0.5f, 0.125f, 0.9f, 0.3f, 1.0f},
        greys{1.0f, 0.2f, 0.7f, 0.1f, 0.6f, 0.9f};
    double worst = 0.0;
    for (std::size_t n = 1; n <= opacities.size(); ++n) {
        double expected = 0.0, through = 1.0;
        for (std::size_t i = 0; i < n; ++i) {
            expected += through * static_cast<double>(opacities[i]) * static_cast<double>(greys[i]);
            through *= 1.0 - static_cast<double>(opacities[i]);
        }
        const SceneDescription scene =
            stack({opacities.begin(), opacities.begin() + static_cast<int>(n)}, greys);
        EventCounter counter;
        const double measured = pixelMean(*compileScene(scene, flat(), 1, 1), 0, 0, 0, 1, counter).x;
        updateWorst(worst, std::abs(measured / expected - 1.0));
        EXPECT_EQ(counter.hits, static_cast<int>(n));
    }
    EXPECT_LT(worst, 12 * 0x1p-52);
    reportDeviation("transparency, product of layers", worst, "relative");
}

TEST(Transparency, TracesThroughTenThousandLayers) {
    constexpr int kLayers = 10000;
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f), Rgb(0.0f), 1.0f, 1e-4f)};
    auto data = std::make_shared<MeshData>();
    for (std::uint32_t i = 0; i < kLayers; ++i) {
        const float z = -1e-3f * static_cast<float>(i);
        for (const glm::vec3& p : {glm::vec3(-1, -1, z), glm::vec3(3, -1, z), glm::vec3(-1, 3, z)})
            data->positions.push_back(p);
        data->triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    scene.meshes = {{"layers", data, {}, {0}, glm::vec3(0)}};
    scene.cameras = {pointCamera({0.1f, 0.2f, 3}, {0.1f, 0.2f, 0})};
    EventCounter counter;
    const double measured = pixelMean(*compileScene(scene, flat(), 1, 1), 0, 0, 0, 1, counter).x;
    const double expected = 1.0 - std::pow(1.0 - static_cast<double>(1e-4f), kLayers);
    EXPECT_EQ(counter.hits, kLayers);
    EXPECT_NEAR(measured, expected, kLayers * 0x1p-52);
    reportDeviation("transparency, 10000 layers", std::abs(measured / expected - 1.0), "relative");
}

TEST(Transparency, OfOpacityZeroShowsTheBackgroundAndOfOneTheSurface) {
    EXPECT_EQ(firstSample(*compileScene(stack({0.0f, 1.0f}, {0.3f, 0.7f}), flat(), 1, 1)), RgbSum(Rgb(0.7f)));
    EXPECT_EQ(firstSample(*compileScene(stack({1.0f, 1.0f}, {0.3f, 0.7f}), flat(), 1, 1)), RgbSum(Rgb(0.3f)));
    Settings off = flat();
    off.transparency = false;
    EXPECT_EQ(firstSample(*compileScene(stack({0.1f, 1.0f}, {0.3f, 0.7f}), off, 1, 1)), RgbSum(Rgb(0.3f)));
}

TEST(Transparency, StopsAtNegligibleThroughput) {
    EventCounter counter;
    pixelMean(
        *compileScene(stack(std::vector<float>(200, 0.5f), std::vector<float>(200, 1.0f)), flat(), 1, 1), 0,
        0, 0, 1, counter);
    EXPECT_EQ(counter.hits, 65);  // until the throughput is 2^-65
    EXPECT_EQ(counter.count(RayEnd::Vanished), 1);
}

/// A floor under three panes, lit from above through them.
SceneDescription panes(float opacity) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f)), material(Rgb(0.0f), Rgb(0.0f), 1.0f, opacity)};
    scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18})};
    for (int i = 0; i < 3; ++i)
        scene.meshes.push_back(quad({-2, 1.0f + static_cast<float>(i), 2}, {4, 0, 0}, {0, 0, -4}, 1));
    scene.lights = {pointLight({0, 5, 0})};
    scene.cameras = {pointCamera({0.5f, 0.5f, 0.5f}, glm::vec3(0.1f, 0, 0.2f))};
    return scene;
}

TEST(Transparency, AttenuatesShadowsWithTransparentShadows) {
    Settings settings = flat();
    EXPECT_EQ(firstSample(*compileScene(panes(0.25f), settings, 1, 1)).x, 0.0);
    settings.transparentShadows = true;
    EXPECT_NEAR(firstSample(*compileScene(panes(0.25f), settings, 1, 1)).x, 0.421875, 1e-12);
    EXPECT_EQ(firstSample(*compileScene(panes(1.0f), settings, 1, 1)).x, 0.0);
    EXPECT_EQ(firstSample(*compileScene(panes(0.0f), settings, 1, 1)).x, 1.0);
    reportDeviation("attenuated shadow through three panes",
                    std::abs(firstSample(*compileScene(panes(0.25f), settings, 1, 1)).x / 0.421875 - 1.0),
                    "relative");
    // A pane behind the light does not attenuate it.
    SceneDescription scene = panes(0.25f);
    scene.lights = {pointLight({0, 2.5f, 0})};
    EXPECT_NEAR(firstSample(*compileScene(scene, settings, 1, 1)).x, 0.5625, 1e-12);
}

TEST(Transparency, CombinesWithReflection) {
    SceneDescription scene = stack({0.5f, 1.0f}, {0.0f, 1.0f});
    scene.materials[0].ks = Rgb(0.5f);
    scene.materials.push_back(material(Rgb(0.25f)));
    scene.meshes.push_back(quad({-1, -1, 5}, {2, 0, 0}, {0, 2, 0}, 2));  // visible in the mirror
    EXPECT_EQ(firstSample(*compileScene(scene, flat(), 1, 1)).x, 0.5 * 0.5 * 0.25 + 0.5 * 1.0);
}

}  // namespace
}  // namespace rayscope::test
