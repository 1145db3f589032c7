// The image files of a render, whole and after a stop.
#include "post/rendered_outputs.h"

#include <gtest/gtest.h>
#include <rayscope/display.h>

#include <chrono>
#include <random>
#include <span>
#include <stop_token>
#include <string>
#include <thread>

#include "support/temporary_folder.h"

namespace rayscope {
namespace {

RgbImage randomPicture(int width, int height) {
    std::mt19937 random(16);
    std::uniform_real_distribution<float> uniform(0.0f, 1.2f);
    RgbImage image(width, height);
    for (Rgb& pixel : image.pixels) pixel = {uniform(random), uniform(random), uniform(random)};
    return image;
}

RgbImage decoded(const std::string& file) { return decodeImage(std::as_bytes(std::span(file)), "file"); }

std::stop_token stopped() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

constexpr const char* kSuffixes[]{".png", ".exr", ".pfm", ".hdr", ".ppm", ".pgm"};
const ImageMetadata kMetadata{{"seed", "7"}};

TEST(RenderedOutputs, WithoutAStopAreThoseOfTheLibrary) {
    const RgbImage mean = randomPicture(70, 40);
    for (const bool bloom : {false, true})
        for (const float exposure : {0.0f, 0.5f}) {
            Settings settings;
            settings.bloom = bloom;
            settings.exposure = exposure;
            const post::RenderedOutputs outputs(mean, settings, {});
            EXPECT_FALSE(outputs.lacksBloom());
            EXPECT_EQ(outputs.settings().bloom, bloom);
            for (const char* suffix : kSuffixes)
                EXPECT_EQ(outputs.encode(suffix, kMetadata),
                          encodeRenderedImage(suffix, mean, settings, kMetadata))
                    << suffix << " " << bloom << " " << exposure;
        }
}

TEST(RenderedOutputs, AfterAStopHaveTheSamePixelsWithoutBloom) {
    const RgbImage mean = randomPicture(70, 40);
    Settings settings, plain;
    settings.exposure = plain.exposure = 0.5f;
    settings.bloom = true;
    const post::RenderedOutputs outputs(mean, settings, stopped());
    EXPECT_TRUE(outputs.lacksBloom());
    EXPECT_EQ(outputs.settings().bloom, false);
    const test::TemporaryFolder folder;
    for (const std::string suffix : kSuffixes) {
        const std::string expected = encodeRenderedImage(suffix, mean, plain, kMetadata);
        const std::string file = outputs.encode(suffix, kMetadata);
        EXPECT_EQ(decoded(file).pixels, decoded(expected).pixels) << suffix;
        outputs.write(folder.file("a" + suffix), kMetadata);
        EXPECT_EQ(test::readText(folder.file("a" + suffix)), file) << suffix;
    }
}

TEST(RenderedOutputs, AfterAStopAreNotCompressed) {
    const RgbImage black(1000, 1000);
    const post::RenderedOutputs outputs(black, {}, stopped());
    EXPECT_GT(outputs.encode(".png", {}).size(), 3'000'000u);
    EXPECT_GT(outputs.encode(".exr", {}).size(), 12'000'000u);
    EXPECT_LT(encodeImage(".png", black).size(), 30'000u);
    EXPECT_LT(encodeImage(".exr", black).size(), 120'000u);
}

/// A stop while a file is compressed, at several moments.
TEST(RenderedOutputs, AStopWhileCompressingKeepsThePixels) {
    const RgbImage mean = randomPicture(600, 600);
    for (const char* suffix : {".png", ".exr"}) {
        const RgbImage expected = decoded(encodeImage(suffix, mean));
        for (const int delay : {0, 1, 5, 20}) {
            std::stop_source stop;
            std::jthread later([&] {
                std::this_thread::sleep_for(std::chrono::milliseconds(delay));
                stop.request_stop();
            });
            const post::RenderedOutputs outputs(mean, {}, stop.get_token());
            EXPECT_EQ(decoded(outputs.encode(suffix, {})).pixels, expected.pixels) << suffix << " " << delay;
        }
    }
}

}  // namespace
}  // namespace rayscope
