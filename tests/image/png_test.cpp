#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include <random>

#include "image/codecs/codecs.h"
#include "image/png_builder.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bigEndian;
using test::bytesOf;
using test::decode;
using test::linearOf;
using test::notesOf;
using test::pngChunk;
using test::pngFile;
using test::PngSpec;
using testing::AllOf;
using testing::HasSubstr;

std::string pngError(const std::string& file) {
    return test::inputErrorOf([&] { decode(file, "x.png"); });
}

/// A file with random samples.
PngSpec randomPng(int colorType, int depth, bool interlaced) {
    PngSpec png{.width = 13, .height = 9, .depth = depth, .colorType = colorType, .interlaced = interlaced};
    std::mt19937 random(7);
    for (int i = 0; i < png.width * png.height * png.channels(); ++i)
        png.samples.push_back(static_cast<std::uint32_t>(random()) & ((1u << depth) - 1));
    if (colorType == 3) {
        std::string palette;
        for (int i = 0; i < 3 << depth; ++i) palette += static_cast<char>(random());
        png.chunks = pngChunk("PLTE", palette);
    }
    return png;
}

/// The pixel at an index, from the definition of the colour types.
Rgb pixelOf(const PngSpec& png, std::size_t pixel) {
    const auto channels = static_cast<std::size_t>(png.channels());
    const auto sample = [&](std::size_t c) { return png.samples[pixel * channels + c]; };
    if (png.colorType == 3) {
        const auto code = [&](std::size_t c) {
            return static_cast<std::uint8_t>(png.chunks[8 + 3 * sample(0) + c]);
        };
        return linearOf(code(0), code(1), code(2));
    }
    const double maximum = static_cast<double>((1u << png.depth) - 1);
    const bool colored = channels >= 3;
    return {linearOf(sample(0), maximum), linearOf(sample(colored ? 1 : 0), maximum),
            linearOf(sample(colored ? 2 : 0), maximum)};
}

TEST(Png, EveryColorTypeDepthAndInterlacing) {
    const std::pair<int, std::vector<int>> kTypes[]{
        {0, {1, 2, 4, 8, 16}}, {2, {8, 16}}, {3, {1, 2, 4, 8}}, {4, {8, 16}}, {6, {8, 16}}};
    for (const auto& [colorType, depths] : kTypes)
        for (const int depth : depths)
            for (const bool interlaced : {false, true}) {
                const PngSpec png = randomPng(colorType, depth, interlaced);
                const RgbImage image = decode(pngFile(png));
                ASSERT_EQ(image.width, png.width);
                ASSERT_EQ(image.height, png.height);
                for (std::size_t i = 0; i < image.pixels.size(); ++i)
                    ASSERT_EQ(image.pixels[i], pixelOf(png, i))
                        << "type " << colorType << " depth " << depth << " pixel " << i;
                EXPECT_EQ(notesOf(pngFile(png)), "");
            }
}

TEST(Png, TransparencyIsIgnored) {
    PngSpec png = randomPng(2, 8, false);
    png.chunks = pngChunk("tRNS", "\0\1\0\2\0\3"s);
    EXPECT_EQ(decode(pngFile(png)).pixels[5], pixelOf(png, 5));
    png = randomPng(3, 4, false);
    const Rgb expected = pixelOf(png, 7);
    png.chunks += pngChunk("tRNS", std::string(16, '\0'));
    EXPECT_EQ(decode(pngFile(png)).pixels[7], expected);
}

TEST(Png, IndicesBeyondThePaletteAreBlackAndReported) {
    const PngSpec png{.width = 3,
                      .depth = 8,
                      .colorType = 3,
                      .samples = {1, 2, 255},
                      .chunks = pngChunk("PLTE", bytesOf({9, 9, 9, 50, 60, 70}))};
    const RgbImage image = decode(pngFile(png));
    EXPECT_EQ(image.at(0, 0), linearOf(50, 60, 70));
    EXPECT_EQ(image.at(1, 0), Rgb(0.0f));
    EXPECT_EQ(image.at(2, 0), Rgb(0.0f));
    EXPECT_THAT(notesOf(pngFile(png)),
                AllOf(HasSubstr("x.img: warning: "), HasSubstr("colours: 2"), HasSubstr("pixels: 2")));
}

std::string grey128With(const std::string& chunks) {
    return pngFile({.colorType = 0, .samples = {128}, .chunks = chunks});
}

TEST(Png, TheTransferFunctionIsThatOfTheFile) {
    const std::string linear = pngChunk("gAMA", bigEndian(100000, 4)), srgb = pngChunk("sRGB", "\0"s);
    EXPECT_EQ(decode(grey128With("")).at(0, 0), Rgb(linearOf(128)));
    EXPECT_EQ(decode(grey128With(srgb)).at(0, 0), Rgb(linearOf(128)));
    EXPECT_EQ(decode(grey128With(linear)).at(0, 0), Rgb(128.0f / 255.0f));
    EXPECT_EQ(decode(grey128With(srgb + pngChunk("gAMA", bigEndian(45455, 4)))).at(0, 0), Rgb(linearOf(128)));
    // What files in sRGB name for programs that do not know the sRGB chunk.
    EXPECT_EQ(decode(grey128With(pngChunk("gAMA", bigEndian(45455, 4)))).at(0, 0), Rgb(linearOf(128)));
    EXPECT_FLOAT_EQ(decode(grey128With(pngChunk("gAMA", bigEndian(50000, 4)))).at(0, 0).x,
                    std::pow(128.0f / 255.0f, 2.0f));
    EXPECT_THAT(notesOf(grey128With(linear)), HasSubstr("exponent 1 "));
    EXPECT_EQ(notesOf(grey128With(srgb)), "");
    EXPECT_FLOAT_EQ(
        decode(pngFile({.depth = 16, .colorType = 0, .samples = {1000}, .chunks = linear})).at(0, 0).x,
        1000.0f / 65535.0f);
}

TEST(Png, WhatIsIgnoredIsReported) {
    const std::string otherPrimaries = [] {
        std::string data;
        for (const std::uint32_t value : {31270u, 32900u, 73470u, 26530u, 27380u, 71740u, 16660u, 890u})
            data += bigEndian(value, 4);
        return pngChunk("cHRM", data);
    }();
    EXPECT_THAT(notesOf(grey128With(otherPrimaries)), HasSubstr("primaries"));
    EXPECT_THAT(notesOf(grey128With(pngChunk("acTL", bigEndian(3, 4) + bigEndian(0, 4)))),
                HasSubstr("animation"));
    EXPECT_THAT(notesOf(grey128With(pngChunk("cICP", bytesOf({9, 16, 0, 1})))), HasSubstr("cICP"));
    EXPECT_EQ(notesOf(grey128With(pngChunk("cICP", bytesOf({1, 13, 0, 1})))), "");
    const std::string rotated = "MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0\6\0\0\0\0\0\0"s;
    EXPECT_THAT(notesOf(grey128With(pngChunk("eXIf", rotated))), HasSubstr("EXIF orientation"));
    EXPECT_EQ(notesOf(grey128With(pngChunk("tEXt", "Title\0x"s))), "");
}

TEST(Png, ChecksumsAreChecked) {
    std::string file = grey128With(pngChunk("gAMA", bigEndian(100000, 4)));
    const std::size_t gamma = file.find("gAMA"), pixels = file.find("IDAT");
    std::string damaged = file;
    damaged[gamma + 8] ^= 1;  // the checksum of a chunk without which the pixels can be read
    EXPECT_THAT(notesOf(damaged), AllOf(HasSubstr("warning"), HasSubstr("gAMA: CRC error")));
    damaged = file;
    damaged[pixels + 12] ^= 1;
    EXPECT_THAT(pngError(damaged), AllOf(HasSubstr("x.png"), HasSubstr("IDAT: ")));
    damaged = file;
    damaged[file.find("IEND") - 5] ^= 1;
    EXPECT_THAT(pngError(damaged), HasSubstr("IDAT: CRC error"));
}

TEST(Png, DamagedFilesAreNamed) {
    std::string file = grey128With("");
    EXPECT_THAT(pngError("\x89PNG\n" + file.substr(6)), HasSubstr("text mode"));
    EXPECT_THAT(pngError(file.substr(0, 8) + pngChunk("CgBI", "\0\0\0\0"s) + file.substr(8)),
                HasSubstr("iOS"));
    EXPECT_THAT(pngError(file.substr(0, file.size() - 12)), HasSubstr("unexpected end of file"));
    EXPECT_THAT(pngError(pngFile({.depth = 3, .colorType = 0, .samples = {1}})), HasSubstr("IHDR"));
    EXPECT_THAT(pngError(pngFile({.depth = 8, .colorType = 3, .samples = {1}})), HasSubstr("PLTE"));
}

TEST(Png, WrittenFilesHoldTheCodesOfEveryPixel) {
    const RgbImage image = test::gradient(37, 11, 1.2f);
    const RgbImage read = decode(image::encodePng(image, {}, Encoding::Srgb));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(read.pixels[i][c], std::min(image.pixels[i][c], 1.0f), 0.005f);
}

}  // namespace
}  // namespace rayscope
