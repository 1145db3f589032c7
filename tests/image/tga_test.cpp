#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include "image/test_images.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bytesOf;
using test::decode;
using test::linearOf;
using test::littleEndian;
using test::notesOf;
using testing::HasSubstr;

struct TgaSpec {
    std::string id{};
    int mapType = 0, type = 2, firstColor = 0, colors = 0, colorBits = 0;
    int width = 2, height = 2, bits = 24, descriptor = 0;
    std::string map{}, pixels{};
};

std::string tgaFile(const TgaSpec& tga) {
    const auto number = [](int value) { return littleEndian(static_cast<std::uint32_t>(value), 2); };
    return bytesOf({static_cast<int>(tga.id.size()), tga.mapType, tga.type}) + number(tga.firstColor) +
           number(tga.colors) + bytesOf({tga.colorBits}) + number(0) + number(0) + number(tga.width) +
           number(tga.height) + bytesOf({tga.bits, tga.descriptor}) + tga.id + tga.map + tga.pixels;
}

std::string errorOf(const std::string& file, const std::string& name = "x.tga") {
    return test::inputErrorOf([&] { decode(file, name); });
}

const std::string kFourColors = bytesOf({0, 0, 255, 0, 255, 0, 255, 0, 0, 99, 99, 99});

TEST(Tga, EveryOrigin) {
    for (const int origin : {0, 16, 32, 48}) {
        const RgbImage image = decode(tgaFile({.descriptor = origin, .pixels = kFourColors}));
        const int left = origin & 16 ? 1 : 0, first = origin & 32 ? 0 : 1;
        EXPECT_EQ(image.at(left, first), linearOf(255, 0, 0)) << origin;
        EXPECT_EQ(image.at(1 - left, first), linearOf(0, 255, 0)) << origin;
        EXPECT_EQ(image.at(left, 1 - first), linearOf(0, 0, 255)) << origin;
        EXPECT_EQ(image.at(1 - left, 1 - first), linearOf(99, 99, 99)) << origin;
    }
}

TEST(Tga, EveryDepthPlainAndInRuns) {
    const Rgb five(linearOf(3, 31), linearOf(30, 31), linearOf(9, 31));
    const std::string packed = littleEndian(3 << 10 | 30 << 5 | 9, 2);
    const struct {
        int type, bits, attributes;
        std::string pixel;
        Rgb color;
    } kKinds[]{{2, 15, 0, packed, five},
               {2, 16, 1, packed, five},
               {2, 24, 0, bytesOf({1, 2, 3}), linearOf(3, 2, 1)},
               {2, 32, 8, bytesOf({1, 2, 3, 4}), linearOf(3, 2, 1)},
               {3, 8, 0, bytesOf({77}), linearOf(77, 77, 77)},
               {3, 16, 8, bytesOf({77, 5}), linearOf(77, 77, 77)}};
    for (const auto& kind : kKinds) {
        SCOPED_TRACE(kind.bits);
        TgaSpec tga{.id = "an identification",
                    .type = kind.type,
                    .width = 3,
                    .bits = kind.bits,
                    .descriptor = kind.attributes};
        const std::string black(kind.pixel.size(), '\0');
        tga.pixels = black + kind.pixel + kind.pixel + kind.pixel + kind.pixel + black;
        const RgbImage plain = decode(tgaFile(tga));
        tga.type += 8;
        // A literal pixel, a run of 4 across the end of the row, a literal pixel.
        tga.pixels = bytesOf({0}) + black + bytesOf({131}) + kind.pixel + bytesOf({0}) + black;
        const RgbImage runs = decode(tgaFile(tga));
        EXPECT_EQ(plain.pixels, runs.pixels);
        EXPECT_EQ(plain.at(0, 1), Rgb(0.0f));
        EXPECT_EQ(plain.at(1, 1), kind.color);
        EXPECT_EQ(plain.at(1, 0), kind.color);
        EXPECT_EQ(plain.at(2, 0), Rgb(0.0f));
        EXPECT_EQ(notesOf(tgaFile(tga)), "");
    }
}

TEST(Tga, ColorMapsOfEveryDepthAndOffset) {
    const struct {
        int bits;
        std::string color;
        Rgb expected;
    } kColors[]{{15, littleEndian(31 << 10 | 7, 2), Rgb(1.0f, 0.0f, linearOf(7, 31))},
                {16, littleEndian(31 << 10 | 7, 2), Rgb(1.0f, 0.0f, linearOf(7, 31))},
                {24, bytesOf({1, 2, 3}), linearOf(3, 2, 1)},
                {32, bytesOf({1, 2, 3, 4}), linearOf(3, 2, 1)}};
    for (const auto& color : kColors)
        for (const int indexBits : {8, 16})
            for (const int first : {0, 5}) {
                const auto index = [&](int i) {
                    return littleEndian(static_cast<std::uint32_t>(first + i), indexBits / 8);
                };
                const std::string file = tgaFile({.mapType = 1,
                                                  .type = 1,
                                                  .firstColor = first,
                                                  .colors = 2,
                                                  .colorBits = color.bits,
                                                  .height = 1,
                                                  .bits = indexBits,
                                                  .map = std::string(color.color.size(), '\0') + color.color,
                                                  .pixels = index(1) + index(0)});
                EXPECT_EQ(decode(file).at(0, 0), color.expected);
                EXPECT_EQ(decode(file).at(1, 0), Rgb(0.0f));
                EXPECT_EQ(notesOf(file), "");
            }
}

TEST(Tga, IndicesOutsideTheColorMapAreBlackAndReported) {
    const std::string file = tgaFile({.mapType = 1,
                                      .type = 1,
                                      .firstColor = 5,
                                      .colors = 1,
                                      .colorBits = 24,
                                      .width = 3,
                                      .height = 1,
                                      .bits = 8,
                                      .map = "aaa",
                                      .pixels = bytesOf({5, 4, 6})});
    const RgbImage image = decode(file);
    EXPECT_EQ(image.at(0, 0), linearOf('a', 'a', 'a'));
    EXPECT_EQ(image.at(1, 0), Rgb(0.0f));
    EXPECT_EQ(image.at(2, 0), Rgb(0.0f));
    EXPECT_THAT(notesOf(file), HasSubstr("pixels: 2"));
}

TEST(Tga, AnUnusedColorMapIsSkipped) {
    const std::string file = tgaFile(
        {.mapType = 1, .colors = 3, .colorBits = 24, .map = std::string(9, 'x'), .pixels = kFourColors});
    EXPECT_EQ(decode(file).at(0, 1), linearOf(255, 0, 0));
}

TEST(Tga, ErrorsNameTheProblem) {
    EXPECT_THAT(errorOf(tgaFile({.descriptor = 64, .pixels = kFourColors})), HasSubstr("interleaved"));
    EXPECT_THAT(errorOf(tgaFile({.pixels = kFourColors.substr(1)})), HasSubstr("unexpected end of file"));
    EXPECT_THAT(errorOf(tgaFile({.type = 10, .pixels = bytesOf({131, 1, 2})})),
                HasSubstr("unexpected end of file"));
    EXPECT_THAT(errorOf(tgaFile({.width = 0})), HasSubstr("0 x 2"));
    EXPECT_THAT(errorOf(tgaFile({.type = 32})), HasSubstr("its type is 32"));
    EXPECT_THAT(errorOf(tgaFile({.type = 1})), HasSubstr("no colour map"));
    EXPECT_THAT(errorOf(tgaFile({.bits = 17})), HasSubstr("17 bits per pixel"));
    EXPECT_THAT(errorOf(tgaFile({.mapType = 7})), HasSubstr("colour map has type 7"));
    EXPECT_THAT(errorOf(tgaFile({.bits = 17}), "x.dat"), HasSubstr("not an image"));
    EXPECT_THAT(errorOf(tgaFile({.width = 60000, .height = 60000, .pixels = kFourColors})),
                HasSubstr("60000 x 60000 pixels, the limit"));
    EXPECT_THAT(errorOf(tgaFile({.width = 9000, .height = 9000, .pixels = kFourColors})),
                HasSubstr("damaged"));
}

TEST(Tga, AGammaIsReported) {
    std::string extension(495, '\0');
    extension.replace(478, 4, littleEndian(22, 2) + littleEndian(10, 2));
    const std::string image = tgaFile({.pixels = kFourColors});
    const std::string footer = littleEndian(static_cast<std::uint32_t>(image.size()), 4) +
                               littleEndian(0, 4) + "TRUEVISION-XFILE.\0"s;
    EXPECT_THAT(notesOf(image + extension + footer), HasSubstr("gamma of the image, 2.2,"));
    EXPECT_EQ(notesOf(image), "");
}

}  // namespace
}  // namespace rayscope
