#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include "image/test_images.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using test::bytesOf;
using test::decode;
using test::linearOf;
using test::littleEndian;
using test::notesOf;
using testing::AllOf;
using testing::HasSubstr;

struct BmpSpec {
    std::uint32_t headerSize = 40;
    int width = 1, height = 1, bits = 24;
    std::uint32_t compression = 0, colors = 0;
    std::string masks{}, palette{}, pixels{};
    std::uint32_t gap = 0;    ///< bytes between the palette and the pixels
    int offset = -1;          ///< of the pixels; −1: as they lie
    std::uint32_t space = 0;  ///< colour space of headers of 108 and 124 bytes
};

std::string bmpFile(const BmpSpec& bmp) {
    std::string header;
    if (bmp.headerSize == 12) {
        header = littleEndian(static_cast<std::uint32_t>(bmp.width), 2) +
                 littleEndian(static_cast<std::uint32_t>(bmp.height), 2) + littleEndian(1, 2) +
                 littleEndian(static_cast<std::uint32_t>(bmp.bits), 2);
    } else {
        header = littleEndian(static_cast<std::uint32_t>(bmp.width), 4) +
                 littleEndian(static_cast<std::uint32_t>(bmp.height), 4) + littleEndian(1, 2) +
                 littleEndian(static_cast<std::uint32_t>(bmp.bits), 2) + littleEndian(bmp.compression, 4) +
                 std::string(12, '\0') + littleEndian(bmp.colors, 4) + std::string(4, '\0');
    }
    if (bmp.headerSize > 40) header += bmp.masks;  // part of the header
    header.resize(bmp.headerSize - 4, '\0');
    if (bmp.headerSize >= 108) header.replace(52, 4, littleEndian(bmp.space, 4));
    const std::string behind =
        (bmp.headerSize <= 40 ? bmp.masks : "") + bmp.palette + std::string(bmp.gap, '\0');
    const std::size_t offset = 14 + bmp.headerSize + behind.size();
    return "BM" + littleEndian(0, 8) +
           littleEndian(
               bmp.offset < 0 ? static_cast<std::uint32_t>(offset) : static_cast<std::uint32_t>(bmp.offset),
               4) +
           littleEndian(bmp.headerSize, 4) + header + behind + bmp.pixels;
}

std::string errorOf(const BmpSpec& bmp) {
    return test::inputErrorOf([&] { decode(bmpFile(bmp), "x.bmp"); });
}

/// 2 × 2 pixels of 24 bits: red and green below, blue and grey above.
const std::string kRows = bytesOf({0, 0, 255, 0, 255, 0, 0, 0, 255, 0, 0, 99, 99, 99, 0, 0});

void expectFourColors(const RgbImage& image, bool topDown = false) {
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.height, 2);
    EXPECT_EQ(image.at(0, topDown ? 0 : 1), linearOf(255, 0, 0));
    EXPECT_EQ(image.at(1, topDown ? 0 : 1), linearOf(0, 255, 0));
    EXPECT_EQ(image.at(0, topDown ? 1 : 0), linearOf(0, 0, 255));
    EXPECT_EQ(image.at(1, topDown ? 1 : 0), linearOf(99, 99, 99));
}

TEST(Bmp, EveryHeaderAndBothDirections) {
    for (const std::uint32_t size : {12u, 16u, 40u, 52u, 56u, 64u, 108u, 124u}) {
        SCOPED_TRACE(size);
        BmpSpec bmp{.headerSize = size, .width = 2, .height = 2, .pixels = kRows};
        expectFourColors(decode(bmpFile(bmp)));
        EXPECT_EQ(notesOf(bmpFile(bmp)), "");
        bmp.gap = 5;
        expectFourColors(decode(bmpFile(bmp)));
        bmp.pixels.resize(bmp.pixels.size() - 2);  // without the padding of the last row
        expectFourColors(decode(bmpFile(bmp)));
        if (size == 12) continue;
        bmp.height = -2;
        expectFourColors(decode(bmpFile(bmp)), true);
    }
}

TEST(Bmp, PalettesOfEveryDepthAndLength) {
    for (const int bits : {1, 2, 4, 8})
        for (const bool os2 : {false, true}) {
            const int colors = 1 << bits;
            BmpSpec bmp{.headerSize = os2 ? 12u : 40u, .width = 2, .bits = bits};
            for (int i = 0; i < colors; ++i)
                bmp.palette += bytesOf({i, 255 - i, 7}) + (os2 ? "" : std::string(1, '\0'));
            const int last = colors - 1;
            bmp.pixels = bits == 8 ? bytesOf({0, last, 0, 0}) : bytesOf({last << (8 - 2 * bits), 0, 0, 0});
            const RgbImage image = decode(bmpFile(bmp));
            EXPECT_EQ(image.at(0, 0), linearOf(7, 255, 0)) << bits;
            EXPECT_EQ(image.at(1, 0), linearOf(7, 255 - last, last)) << bits;
        }
}

TEST(Bmp, IndicesBeyondThePaletteAreBlackAndReported) {
    // Once because the header says so, once because the pixels follow the palette too early.
    BmpSpec bmp{.width = 2, .bits = 8, .colors = 2, .palette = bytesOf({1, 2, 3, 0, 4, 5, 6, 0})};
    bmp.pixels = bytesOf({1, 2, 0, 0});
    for (const std::uint32_t colors : {2u, 0u}) {
        bmp.colors = colors;
        EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0), linearOf(6, 5, 4));
        EXPECT_EQ(decode(bmpFile(bmp)).at(1, 0), Rgb(0.0f));
        EXPECT_THAT(notesOf(bmpFile(bmp)), HasSubstr("colours: 2"));
    }
    bmp.colors = 300;  // more than the pixels can name
    bmp.palette = std::string(1200, '\x40');
    EXPECT_EQ(decode(bmpFile(bmp)).at(1, 0), linearOf(64, 64, 64));
}

TEST(Bmp, BitFieldsOfAnyPlaceAndWidth) {
    const auto masks = [](std::initializer_list<std::uint32_t> values) {
        std::string bytes;
        for (const std::uint32_t mask : values) bytes += littleEndian(mask, 4);
        return bytes;
    };
    BmpSpec bmp{.bits = 16, .pixels = littleEndian(31 << 10 | 7 << 5 | 3, 4)};
    EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0), Rgb(1.0f, linearOf(7, 31), linearOf(3, 31)));
    bmp.compression = 3;
    bmp.masks = masks({0xf800, 0x7e0, 0x1f});
    bmp.pixels = littleEndian(9 << 11 | 50 << 5 | 3, 4);
    EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0), Rgb(linearOf(9, 31), linearOf(50, 63), linearOf(3, 31)));
    bmp.bits = 32;
    bmp.masks = masks({0x3ff00000, 0x000ffc00, 0x1ff});
    bmp.pixels = littleEndian(1000u << 20 | 513u << 10 | 3u, 4);
    for (const std::uint32_t size : {40u, 52u, 56u, 108u, 124u}) {
        bmp.headerSize = size;
        EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0),
                  Rgb(linearOf(1000, 1023), linearOf(513, 1023), linearOf(3, 511)));
    }
    bmp.masks = masks({0xff, 0, 0xff000000});
    bmp.pixels = bytesOf({10, 20, 30, 40});
    EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0), linearOf(10, 0, 40));
    bmp.headerSize = 40;
    bmp.compression = 6;  // a fourth mask
    bmp.masks += std::string(4, '\0');
    EXPECT_EQ(decode(bmpFile(bmp)).at(0, 0), linearOf(10, 0, 40));
    bmp.masks = masks({0xf0f, 0xf0, 0xff0000, 0});
    EXPECT_THAT(errorOf(bmp), HasSubstr("0x00000f0f"));
    bmp.compression = 0;
    EXPECT_EQ(decode(bmpFile({.bits = 32, .pixels = bytesOf({10, 20, 30, 40})})).at(0, 0),
              linearOf(30, 20, 10));
}

std::string greyPalette(int colors) {
    std::string palette;
    for (int i = 0; i < colors; ++i) palette += bytesOf({i, i, i, 0});
    return palette;
}

std::string codesOf(const RgbImage& image) {
    std::string codes;
    for (const Rgb& pixel : image.pixels)
        for (int code = 0; code < 256; ++code)
            if (pixel.x == linearOf(code)) codes += std::to_string(code) + " ";
    return codes;
}

TEST(Bmp, RunLengthCodes) {
    // Two 5s; three literal pixels and padding; end of line. Below the top row: a delta of (1, 0), then one
    // 9; end.
    BmpSpec bmp{.width = 5, .height = 2, .bits = 8, .compression = 1, .palette = greyPalette(256)};
    bmp.pixels = bytesOf({2, 5, 0, 3, 6, 7, 8, 0, 0, 0, 0, 2, 1, 0, 1, 9, 0, 1});
    EXPECT_EQ(codesOf(decode(bmpFile(bmp))), "0 9 0 0 0 5 5 6 7 8 ");
    EXPECT_THAT(notesOf(bmpFile(bmp)), AllOf(HasSubstr("note"), HasSubstr("first colour (pixels: 4)")));
    // Four pixels 1 2 1 2, one literal 3 and padding; then a run beyond the end of the second row.
    bmp.bits = 4;
    bmp.compression = 2;
    bmp.palette = greyPalette(16);
    bmp.pixels = bytesOf({4, 0x12, 0, 3, 0x34, 0x50, 0, 0, 20, 0x67, 0, 1});
    EXPECT_EQ(codesOf(decode(bmpFile(bmp))), "6 7 6 7 6 1 2 1 2 3 ");
    EXPECT_THAT(notesOf(bmpFile(bmp)), AllOf(HasSubstr("warning"), HasSubstr("leaves the image")));
    bmp.pixels = bytesOf({8, 0x12, 0, 0, 8, 0x34, 0, 1});  // the padding of rows is coded
    EXPECT_EQ(notesOf(bmpFile(bmp)), "");
    // The code of OS/2 for 24 bits.
    const BmpSpec colors{.headerSize = 64,
                         .width = 3,
                         .bits = 24,
                         .compression = 4,
                         .pixels = bytesOf({2, 1, 2, 3, 1, 4, 5, 6, 0, 1})};
    EXPECT_EQ(decode(bmpFile(colors)).at(1, 0), linearOf(3, 2, 1));
    EXPECT_EQ(decode(bmpFile(colors)).at(2, 0), linearOf(6, 5, 4));
}

TEST(Bmp, ACutRunLengthCodeIsDamaged) {
    BmpSpec bmp{.width = 3, .height = 2, .bits = 8, .compression = 1, .palette = greyPalette(256)};
    bmp.pixels = bytesOf({3, 1, 0, 0, 3, 2});  // whole, without an end
    EXPECT_EQ(codesOf(decode(bmpFile(bmp))), "2 2 2 1 1 1 ");
    bmp.pixels = bytesOf({3, 1, 0, 0, 3});
    EXPECT_THAT(errorOf(bmp), HasSubstr("unexpected end of file"));
    bmp.pixels = bytesOf({3, 1, 0, 0});
    EXPECT_THAT(errorOf(bmp), HasSubstr("unexpected end of file"));
}

TEST(Bmp, WhatIsNotReadIsNamed) {
    EXPECT_THAT(errorOf({.bits = 0, .compression = 4}), HasSubstr("contains a JPEG image"));
    EXPECT_THAT(errorOf({.bits = 0, .compression = 5}), HasSubstr("contains a PNG image"));
    EXPECT_THAT(errorOf({.headerSize = 64, .bits = 1, .compression = 3}), HasSubstr("Huffman"));
    EXPECT_THAT(errorOf({.bits = 32, .compression = 11}), HasSubstr("CMYK"));
    EXPECT_THAT(errorOf({.bits = 64}), HasSubstr("64 bits"));
    EXPECT_THAT(errorOf({.bits = 7}), HasSubstr("7 bits per pixel"));
    EXPECT_THAT(errorOf({.bits = 24, .compression = 1}), HasSubstr("run-length code for 8 bits"));
    EXPECT_THAT(errorOf({.compression = 77}), HasSubstr("compression is 77"));
    EXPECT_THAT(errorOf({.headerSize = 99}), HasSubstr("header has 99 bytes"));
    EXPECT_THAT(errorOf({.width = 0, .pixels = kRows}), HasSubstr("0 x 1"));
    EXPECT_THAT(errorOf({.width = -4, .pixels = kRows}), HasSubstr("-4 x 1"));
    EXPECT_THAT(errorOf({.height = 0, .pixels = kRows}), HasSubstr("1 x 0"));
    EXPECT_THAT(errorOf({.width = 17000, .height = -17000}), HasSubstr("17000 x 17000 pixels, the limit"));
    EXPECT_THAT(errorOf({.width = 3, .height = 2, .pixels = kRows}),
                HasSubstr("16 bytes of pixels instead of 21"));
}

TEST(Bmp, AWrongOffsetAndAColorSpaceAreReported) {
    const BmpSpec bmp{.width = 2, .height = 2, .pixels = kRows, .offset = 3};
    expectFourColors(decode(bmpFile(bmp)));
    EXPECT_THAT(notesOf(bmpFile(bmp)), AllOf(HasSubstr("warning"), HasSubstr("offset of the pixels, 3,")));
    EXPECT_THAT(notesOf(bmpFile({.headerSize = 124, .pixels = kRows, .space = 0x4d424544})),
                HasSubstr("ICC profile"));
    EXPECT_EQ(notesOf(bmpFile({.headerSize = 124, .pixels = kRows, .space = 0x73524742})), "");
}

}  // namespace
}  // namespace rayscope
