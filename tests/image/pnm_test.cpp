// PBM, PGM, PPM, PAM and PFM files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include <limits>

#include "image/test_images.h"
#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bytesOf;
using test::decode;
using test::linearOf;
using test::littleEndian;
using test::notesOf;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string pnmError(const std::string& file) {
    return test::inputErrorOf([&] { decode(file, "x.pnm"); });
}

TEST(Pnm, BitmapsAsTextAndBinary) {
    const Rgb black(0.0f), white(1.0f);
    for (const std::string& file :
         {"P1\n3 2\n1 0 1\n0 1 0\n"s, "P1 3 2 101010"s, "P1 # a remark\n3 2\n10#x\n1 010"s,
          "P4\n3 2\n"s + bytesOf({0b10100000, 0b01000000}), "P4 3 2 "s + bytesOf({0b10111111, 0b01011111})})
        EXPECT_THAT(decode(file).pixels, ElementsAre(black, white, black, white, black, white)) << file;
    const RgbImage wide = decode("P4 9 1\n"s + bytesOf({0x7f, 0x7f}));
    EXPECT_EQ(wide.at(0, 0), white);
    EXPECT_EQ(wide.at(8, 0), white);
    EXPECT_EQ(wide.at(7, 0), black);
}

TEST(Pnm, GraysOfEveryMaximum) {
    for (const int maximum : {1, 2, 7, 99, 255, 256, 1000, 65535})
        for (const int value : {0, 1, maximum / 2, maximum}) {
            const std::string header = std::to_string(maximum), sample = std::to_string(value);
            const std::string binary =
                maximum > 255 ? test::bigEndian(static_cast<std::uint32_t>(value), 2) : bytesOf({value});
            const Rgb expected(linearOf(value, maximum));
            EXPECT_EQ(decode("P2\n1 1\n" + header + "\n" + sample).at(0, 0), expected);
            EXPECT_EQ(decode("P5\n1 1\n" + header + "\n" + binary).at(0, 0), expected);
            EXPECT_EQ(decode("P3 1 1 " + header + " 0 " + sample + " 0").at(0, 0),
                      Rgb(0.0f, expected.y, 0.0f));
            EXPECT_EQ(decode("P6 1 1 " + header + "\n" + binary + binary + binary).at(0, 0), expected);
        }
}

TEST(Pnm, HeadersWithRemarksAndAnyWhiteSpace) {
    const Rgb expected = linearOf(1, 2, 3);
    const std::string pixel = bytesOf({1, 2, 3});
    for (const std::string header :
         {"P6 1 1 255 ", "P6\r\n1 1\r\n255\r\n", "P6\r1\r1\r255\r", "P6\n# GIMP\n1 1\n255\n",
          "P6#x\n1#y\n1\n#z\n255#w\n", "P6\t1\v1\f255\t", "P6\n\n  1   1\n\n255\n"})
        EXPECT_EQ(decode(header + pixel).at(0, 0), expected) << header;
    // White space and remarks may be pixels.
    EXPECT_EQ(decode("P5 1 1 255\n#").at(0, 0), Rgb(linearOf('#')));
    EXPECT_EQ(decode("P5 1 1 255\r\n").at(0, 0), Rgb(linearOf('\n')));
}

TEST(Pnm, ArbitraryMaps) {
    const auto header = [](const char* depth, const char* maximum, const char* type) {
        return "P7\nWIDTH 1\nHEIGHT 1\n# a remark\nDEPTH "s + depth + "\nMAXVAL " + maximum + "\nTUPLTYPE " +
               type + "\nENDHDR\n";
    };
    EXPECT_EQ(decode(header("3", "255", "RGB") + bytesOf({1, 2, 3})).at(0, 0), linearOf(1, 2, 3));
    EXPECT_EQ(decode(header("4", "255", "RGB_ALPHA") + bytesOf({1, 2, 3, 4})).at(0, 0), linearOf(1, 2, 3));
    EXPECT_EQ(decode(header("2", "65535", "GRAYSCALE_ALPHA") + bytesOf({1, 0, 0, 0})).at(0, 0),
              Rgb(linearOf(256, 65535)));
    EXPECT_EQ(decode(header("1", "1", "BLACKANDWHITE") + bytesOf({1})).at(0, 0), Rgb(1.0f));
    EXPECT_THAT(pnmError(header("5", "255", "RGB_ALPHA") + "12345"), HasSubstr("5 channels"));
    EXPECT_THAT(pnmError("P7\nWIDTH 1\nHEIGHT 1\nPIXELS\n"), HasSubstr("ENDHDR"));
}

TEST(Pnm, ErrorsNameTheProblem) {
    EXPECT_THAT(pnmError("P5\n2 1\n255\na"), HasSubstr("unexpected end of file"));
    EXPECT_THAT(pnmError("P2\n2 1\n255\n7"), HasSubstr("unexpected end of file"));
    EXPECT_THAT(pnmError("P1\n2 1\n1"), HasSubstr("unexpected end of file"));
    EXPECT_THAT(pnmError("P2\n2 1\n255\n7 256"), HasSubstr("value 256, the maximum is 255"));
    EXPECT_THAT(pnmError("P2\n2 1\n255\n7 -1"), HasSubstr("value -1, the maximum is 255"));
    EXPECT_THAT(pnmError("P5\n1 1\n100\ne"), HasSubstr("value 101, the maximum is 100"));
    EXPECT_THAT(pnmError("P2\n2 1\n255\n7 x"), HasSubstr("not a number"));
    EXPECT_THAT(pnmError("P1\n2 1\n12"), HasSubstr("0 and 1"));
    for (const char* maximum : {"0", "65536", "-1"})
        EXPECT_THAT(pnmError("P5\n1 1\n"s + maximum + "\naa"), HasSubstr("expected 1 to 65535"));
    EXPECT_THAT(pnmError("P5\nx 1\n255\na"), HasSubstr("width"));
    EXPECT_THAT(pnmError("P5\n1\n"), HasSubstr("height"));
    EXPECT_THAT(pnmError("P5\n0 1\n255\na"), HasSubstr("0 x 1"));
    EXPECT_THAT(pnmError("P5\n99999 99999\n255\na"), HasSubstr("99999 x 99999 pixels, the limit"));
}

TEST(Pnm, WhatFollowsThePixelsIsReported) {
    EXPECT_EQ(notesOf("P5\n1 1\n255\na"), "");
    EXPECT_EQ(notesOf("P2\n1 1\n255\n7\n\n"), "");
    EXPECT_THAT(notesOf("P5\n1 1\n255\naP5\n1 1\n255\nb"), HasSubstr("only the first"));
    EXPECT_THAT(notesOf("P5\n1 1\n255\nabc"), HasSubstr("2 bytes behind the pixels"));
}

TEST(Pnm, WrittenFilesHoldSrgbCodes) {
    const test::TemporaryFolder folder;
    RgbImage image(2, 1, Rgb(0.5f, 0.0f, 7.0f));
    image.at(1, 0) =
        Rgb(std::numeric_limits<float>::quiet_NaN(), 1.0f, std::numeric_limits<float>::infinity());
    writeImage(folder.file("a.ppm"), image);
    EXPECT_EQ(test::readText(folder.file("a.ppm")), "P6\n2 1\n255\n" + bytesOf({188, 0, 255, 0, 255, 255}));
    writeImage(folder.file("b.ppm"), image, {}, Encoding::None);
    EXPECT_EQ(test::readText(folder.file("b.ppm")), "P6\n2 1\n255\n" + bytesOf({127, 0, 255, 0, 255, 255}));
    writeImage(folder.file("a.PGM"), RgbImage(1, 1, Rgb(0.0f, 0.5f, 0.0f)));
    EXPECT_EQ(decode(test::readText(folder.file("a.PGM"))).at(0, 0).x, linearOf(161));  // 0.7152 · 0.5
}

const std::string kOne("\x3f\x80\0\0", 4), kTwo("\x40\0\0\0", 4);

TEST(Pfm, HeadersOfOtherWriters) {
    for (const std::string header : {"PF\n1 1\n1.0\n", "PF\r\n1 1\r\n1.0\r\n", "PF\n# a remark\n1 1\n+1.0\n",
                                     "PF 1 1 1\n", "PF\n1 1\n1.000000 "}) {
        EXPECT_EQ(decode(header + kOne + kTwo + kOne).at(0, 0), Rgb(1.0f, 2.0f, 1.0f)) << header;
        EXPECT_EQ(notesOf(header + kOne + kTwo + kOne), "");
    }
    EXPECT_EQ(decode("PF4\n1 1\n1.0\n" + kOne + kTwo + kTwo + kOne).at(0, 0), Rgb(1.0f, 2.0f, 2.0f));
}

TEST(Pfm, OdditiesAreReported) {
    EXPECT_THAT(notesOf("Pf\n1 1\n-2.5\n" + kOne), HasSubstr("multiplied by its scale, 2.5"));
    EXPECT_THAT(notesOf("Pf\n1 1\n1\n" + kOne + "ab"), HasSubstr("2 bytes behind the pixels"));
    EXPECT_THAT(pnmError("Pf\n1 1\nnan\n" + kOne), HasSubstr("scale is nan"));
    EXPECT_THAT(pnmError("Pf\n1 1\n1e99\n" + kOne), HasSubstr("scale"));
    EXPECT_THAT(pnmError("PF\n1 1\n1\n" + kOne), HasSubstr("unexpected end of file"));
}

TEST(Pnm, PamTypesOfOtherColoursAreRefused) {
    const std::string cmyk =
        "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE CMYK\nENDHDR\n"s + bytesOf({0, 255, 255, 0});
    EXPECT_THAT(pnmError(cmyk), HasSubstr("is a PAM image of the type CMYK"));
    const std::string rgba = "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n"s +
                             bytesOf({255, 0, 0, 255});
    EXPECT_THAT(decode(rgba).pixels, ElementsAre(Rgb(1.0f, 0.0f, 0.0f)));
}

TEST(Pfm, BlanksBehindTheScale) {
    const std::string pixel = littleEndian(0x3f800000u, 4);
    for (const std::string& end : {"\n"s, " \n"s, "  \t\n"s, "\r\n"s})
        EXPECT_THAT(decode("Pf\n1 1\n-1.0" + end + pixel).pixels, ElementsAre(Rgb(1.0f)));
}

}  // namespace
}  // namespace rayscope
