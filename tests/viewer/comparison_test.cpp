#include "viewer/jobs/comparison.h"

#include <gtest/gtest.h>

#include <thread>

#include "traced.h"

namespace rayscope::viewer {
namespace {

RgbImage flat(int width, int height, float value) {
    RgbImage image(width, height);
    for (Rgb& pixel : image.pixels) pixel = Rgb(value);
    return image;
}

void settle(Comparison& comparison, const RgbImage& b, int revision) {
    comparison.update(b, revision, true, 0.0f);
    while (comparison.busy()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        comparison.update(b, revision, true, 0.0f);
    }
}

TEST(Comparison, MeasuresTheCurrentPictureAgainstTheKeptOne) {
    Comparison comparison;
    EXPECT_FALSE(comparison.visible());
    settle(comparison, flat(16, 16, 0.5f), 1);
    EXPECT_EQ(comparison.metrics(), nullptr) << "there is no A";
    comparison.keep(flatPicture(16, 16, 0.25f));
    EXPECT_FALSE(comparison.visible()) << "not requested";
    comparison.view.shown = true;
    settle(comparison, flat(16, 16, 0.75f), 1);
    ASSERT_NE(comparison.metrics(), nullptr);
    EXPECT_DOUBLE_EQ(comparison.metrics()->rmse, 0.5);
    EXPECT_TRUE(comparison.metricsAreFinal());
    settle(comparison, flat(16, 16, 0.25f), 2);
    EXPECT_EQ(comparison.metrics()->rmse, 0.0);
    EXPECT_EQ(comparison.metrics()->ssim, 1.0);
    EXPECT_EQ(comparison.metrics()->flip, 0.0);
}

TEST(Comparison, ReportsWhetherMetricsAreOfTheCompletePicture) {
    Comparison comparison;
    comparison.keep(flatPicture(16, 16, 0.25f));
    comparison.view.shown = true;
    const RgbImage b = flat(16, 16, 0.5f);
    const auto wait = [&](bool complete, int revision, const RgbImage& image) {
        do comparison.update(image, revision, complete, 0.0f);
        while (comparison.busy());
    };
    wait(false, 1, b);
    ASSERT_NE(comparison.metrics(), nullptr) << "preliminary metrics";
    EXPECT_FALSE(comparison.metricsAreFinal());
    // The picture did not change since: the metrics become final without another measurement.
    comparison.update(b, 1, true, 0.0f);
    EXPECT_FALSE(comparison.busy());
    EXPECT_TRUE(comparison.metricsAreFinal());
    // Tiles that are collected after the render ended.
    comparison.update(flat(16, 16, 0.75f), 2, true, 0.0f);
    EXPECT_FALSE(comparison.metricsAreFinal());
    wait(true, 2, flat(16, 16, 0.75f));
    EXPECT_TRUE(comparison.metricsAreFinal());
    EXPECT_DOUBLE_EQ(comparison.metrics()->rmse, 0.5);
    // Exposure affects perceptual metrics.
    comparison.update(flat(16, 16, 0.75f), 2, true, 1.0f);
    EXPECT_TRUE(comparison.busy());
    EXPECT_FALSE(comparison.metricsAreFinal());
}

TEST(Comparison, HasNoMetricsForOtherSizesOrDiscardedPictures) {
    Comparison comparison;
    comparison.keep(flatPicture(16, 16, 0.25f));
    comparison.view.shown = true;
    settle(comparison, flat(16, 16, 0.5f), 1);
    ASSERT_NE(comparison.metrics(), nullptr);
    settle(comparison, flat(17, 16, 0.5f), 2);
    EXPECT_EQ(comparison.metrics(), nullptr);
    const int version = comparison.view.version;
    comparison.discard();
    EXPECT_EQ(comparison.a(), nullptr);
    EXPECT_FALSE(comparison.visible());
    EXPECT_GT(comparison.view.version, version);
}

TEST(Comparison, ListsDifferentSettings) {
    RenderRequest a, b;
    EXPECT_TRUE(differencesOf(a, b).empty());
    b.settings.spp = 64;
    b.settings.hardShadows = false;
    b.camera.fov += 1.0f;
    EXPECT_EQ(differencesOf(a, b),
              (std::vector<std::string>{"hard_shadows true -> false", "spp 16 -> 64", "camera"}));
}

}  // namespace
}  // namespace rayscope::viewer
