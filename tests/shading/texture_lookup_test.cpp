#include "shading/texture_lookup.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rayscope {
namespace {

std::shared_ptr<Texture> noise(int width, int height, TextureWrap wrap = TextureWrap::Repeat) {
    auto texture = std::make_shared<Texture>();
    texture->image = RgbImage(width, height);
    texture->wrap = wrap;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform;
    for (Rgb& pixel : texture->image.pixels) pixel = {uniform(random), uniform(random), uniform(random)};
    return texture;
}

glm::dvec3 meanOf(const RgbImage& image) {
    glm::dvec3 sum(0.0);
    for (const Rgb& pixel : image.pixels) sum += glm::dvec3(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

TEST(MipTexture, EndsInTheMeanOfTheImageForEverySize) {
    for (const auto& [width, height] : {std::pair{8, 8}, {16, 4}, {5, 5}, {7, 3}, {1, 9}, {100, 37}}) {
        const auto texture = noise(width, height);
        const shading::MipTexture mip(texture, true);
        const glm::dvec3 value = mip.lookup({0.3f, 0.8f}, 1e6, TextureFilter::Mipmap);
        EXPECT_LT(glm::distance(value, meanOf(texture->image)), 1e-6) << width << " x " << height;
    }
}

TEST(MipTexture, CanBeStoppedWhileItsLevelsAreMade) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(shading::MipTexture(noise(8, 8), true, stop.get_token()), Stopped);
    EXPECT_NO_THROW(shading::MipTexture(noise(8, 8), false, stop.get_token()));
}

TEST(MipTexture, WithASmallFootprintIsBilinear) {
    const shading::MipTexture mip(noise(8, 8), true);
    for (const float u : {0.1f, 0.45f, 0.9f})
        EXPECT_EQ(mip.lookup({u, 0.3f}, 0.12, TextureFilter::Mipmap),
                  mip.lookup({u, 0.3f}, 0.0, TextureFilter::Bilinear));
}

TEST(MipTexture, BlursContinuously) {
    const shading::MipTexture mip(noise(64, 64), true);
    glm::dvec3 before = mip.lookup({0.31f, 0.77f}, 0.005, TextureFilter::Mipmap);
    for (double footprint = 0.005; footprint < 2.0; footprint *= 1.01) {
        const glm::dvec3 value = mip.lookup({0.31f, 0.77f}, footprint, TextureFilter::Mipmap);
        EXPECT_LT(glm::distance(value, before), 0.03);
        before = value;
    }
}

TEST(TextureLookup, IsDefinedForEveryCoordinate) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp}) {
        const shading::MipTexture mip(noise(3, 5, wrap), true);
        for (const float u : {-1e-9f, -0.0f, 0.0f, 1.0f, 1.0f - 0x1p-24f, 1e9f, -1e30f, infinity, -infinity,
                              std::numeric_limits<float>::quiet_NaN()})
            for (const TextureFilter filter :
                 {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Mipmap})
                for (const glm::vec2& uv : {glm::vec2(u, 0.5f), glm::vec2(0.5f, u), glm::vec2(u, u)}) {
                    const glm::dvec3 c = mip.lookup(uv, 0.5, filter);
                    EXPECT_TRUE(c.x >= 0.0 && c.x <= 1.0) << u;
                }
    }
}

TEST(BilinearTap, HasTexelCentresAtHalfIntegers) {
    const shading::BilinearTap tap = shading::bilinearTap(
        4, 4, {0.375, 0.625}, TextureWrap::Clamp);  // the centre of texel (1, 1), counted from the top
    EXPECT_EQ(tap.x[0], 1);
    EXPECT_EQ(tap.y[0], 1);
    EXPECT_EQ(tap.weightX, 0.0);
    EXPECT_EQ(tap.weightY, 0.0);
    const shading::BilinearTap wrapped = shading::bilinearTap(4, 4, {0.0, 0.0}, TextureWrap::Repeat);
    EXPECT_EQ(wrapped.x[0], 3);
    EXPECT_EQ(wrapped.x[1], 0);
    EXPECT_EQ(wrapped.y[0], 3);
    EXPECT_EQ(wrapped.y[1], 0);
    EXPECT_EQ(wrapped.weightX, 0.5);
}

}  // namespace
}  // namespace rayscope
