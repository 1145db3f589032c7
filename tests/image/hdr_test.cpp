#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include <cmath>
#include <limits>

#include "image/codecs/codecs.h"
#include "image/test_images.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using test::bytesOf;
using test::decode;
using test::notesOf;
using testing::AllOf;
using testing::HasSubstr;

const std::string kRgbe = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";

std::string hdrError(const std::string& file) {
    return test::inputErrorOf([&] { decode(file, "x.hdr"); });
}

/// A pixel with mantissas of 128 and the exponent 1: the value (r, g, b) / 128.
std::string pixel(int r, int g, int b) { return bytesOf({r, g, b, 129}); }
Rgb value(int r, int g, int b) {
    return {static_cast<float>(r) / 128.0f, static_cast<float>(g) / 128.0f, static_cast<float>(b) / 128.0f};
}

TEST(Hdr, FlatPixels) {
    for (const std::string header :
         {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n", "#?RGBE\n\n-Y 1 +X 2\n",
          "#?RADIANCE\r\n# a remark\r\nFORMAT = 32-bit_rle_rgbe \r\n\r\n-Y 1 +X 2\r\n",
          "#?AUTOPANO\nrpict -vp 0 0 0\nVIEW= -vth\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n"}) {
        const RgbImage image = decode(header + pixel(128, 200, 3) + bytesOf({9, 9, 9, 0}));
        EXPECT_EQ(image.at(0, 0), value(128, 200, 3)) << header;
        EXPECT_EQ(image.at(1, 0), Rgb(0.0f));
        EXPECT_EQ(notesOf(header + pixel(1, 2, 3) + pixel(1, 2, 3)), "");
    }
}

TEST(Hdr, AllOrientations) {
    // Two scan lines of three pixels: 1 2 3, then 4 5 6.
    std::string pixels;
    for (int i = 1; i <= 6; ++i) pixels += pixel(i + 100, 0, 0);
    const struct {
        const char* size;
        int width;
        std::vector<int> rows;  ///< from the top left
    } kOrientations[]{{"-Y 2 +X 3", 3, {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", 3, {3, 2, 1, 6, 5, 4}},
                      {"+Y 2 +X 3", 3, {4, 5, 6, 1, 2, 3}}, {"+Y 2 -X 3", 3, {6, 5, 4, 3, 2, 1}},
                      {"+X 2 -Y 3", 2, {1, 4, 2, 5, 3, 6}}, {"-X 2 -Y 3", 2, {4, 1, 5, 2, 6, 3}},
                      {"+X 2 +Y 3", 2, {3, 6, 2, 5, 1, 4}}, {"-X 2 +Y 3", 2, {6, 3, 5, 2, 4, 1}}};
    for (const auto& orientation : kOrientations) {
        const RgbImage image = decode(kRgbe + "\n" + orientation.size + "\n" + pixels);
        ASSERT_EQ(image.width, orientation.width) << orientation.size;
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_EQ(image.pixels[i], value(orientation.rows[i] + 100, 0, 0))
                << orientation.size << " pixel " << i;
    }
}

/// A scan line of 8 pixels in the newer run-length code: 5 × a, then 3 literal bytes.
std::string newLine(int a) {
    std::string line = bytesOf({2, 2, 0, 8});
    for (int channel = 0; channel < 3; ++channel) line += bytesOf({133, a, 3, 50, 60, 70});
    return line + bytesOf({136, 129});
}

TEST(Hdr, EachScanLineHasItsOwnCode) {
    std::string flat;
    for (int i = 0; i < 8; ++i) flat += pixel(i, 9, 9);
    const std::string old = pixel(7, 8, 9) + bytesOf({1, 1, 1, 5}) + pixel(4, 4, 4) + pixel(5, 5, 5);
    const RgbImage image = decode(kRgbe + "\n-Y 4 +X 8\n" + newLine(33) + flat + old + newLine(44));
    EXPECT_EQ(image.at(4, 0), value(33, 33, 33));
    EXPECT_EQ(image.at(7, 0), value(70, 70, 70));
    EXPECT_EQ(image.at(3, 1), value(3, 9, 9));
    for (int x = 0; x < 6; ++x) EXPECT_EQ(image.at(x, 2), value(7, 8, 9));
    EXPECT_EQ(image.at(6, 2), value(4, 4, 4));
    EXPECT_EQ(image.at(0, 3), value(44, 44, 44));
}

TEST(Hdr, ConsecutiveRunsOfTheOldCodeCountInBytes) {
    const std::string file =
        kRgbe + "\n-Y 1 +X 600\n" + pixel(3, 4, 5) + bytesOf({1, 1, 1, 86, 1, 1, 1, 2}) + pixel(6, 6, 6);
    const RgbImage image = decode(file);  // 1 + 86 + 2 · 256 + 1 pixels
    EXPECT_EQ(image.at(598, 0), value(3, 4, 5));
    EXPECT_EQ(image.at(599, 0), value(6, 6, 6));
}

TEST(Hdr, ExposureAndColorCorrectionAreUndone) {
    const auto read = [](const std::string& variables) {
        return decode(kRgbe + variables + "\n-Y 1 +X 1\n" + pixel(128, 64, 32)).at(0, 0);
    };
    EXPECT_EQ(read("EXPOSURE=2\n"), value(64, 32, 16));
    EXPECT_EQ(read("EXPOSURE= 4.0\nEXPOSURE=+0.5\n"), value(64, 32, 16));
    EXPECT_EQ(read("COLORCORR=1 2 4\nEXPOSURE=2\n"), value(64, 16, 4));
    EXPECT_EQ(read("EXPOSURE=-1\n"), value(128, 64, 32));
    const auto notes = [](const std::string& variables) {
        return notesOf(kRgbe + variables + "\n-Y 1 +X 1\n" + pixel(1, 2, 3));
    };
    EXPECT_THAT(notes("EXPOSURE=2\n"), AllOf(HasSubstr("note"), HasSubstr("divided by 2 2 2")));
    for (const std::string bad : {"EXPOSURE=-1", "EXPOSURE=nan", "EXPOSURE=", "EXPOSURE=0", "COLORCORR=1 2",
                                  "PIXASPECT=2", "GAMMA=2.2", "PRIMARIES=0 0 0 0 0 0 0 0"})
        EXPECT_THAT(notes(bad + "\n"), AllOf(HasSubstr("warning"), HasSubstr(bad + " is ignored")));
    for (const char* usual : {"PIXASPECT=1.0\n", "GAMMA=1\n", "\tEXPOSURE=2\n", "# EXPOSURE=2\n",
                              "PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n"})
        EXPECT_EQ(notes(usual), "");
}

TEST(Hdr, XyzIsConvertedToSrgb) {
    // The white point of sRGB, (0.9505, 1, 1.089), becomes grey.
    const std::string file =
        "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n" + pixel(122, 128, 139) + pixel(0, 128, 0);
    const RgbImage image = decode(file);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(0, 0)[c], 1.0f, 0.02f);
    EXPECT_EQ(image.at(1, 0), Rgb(0.0f, 1.8758f, 0.0f));
    EXPECT_THAT(notesOf(file), HasSubstr("XYZ"));
}

TEST(Hdr, DamagedFilesAreNamed) {
    const std::string line = newLine(3);
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 8\n" + line.substr(0, line.size() - 1)),
                HasSubstr("unexpected end of file"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 9\n" + line), HasSubstr("another length"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 8\n" + bytesOf({2, 2, 0, 8, 137, 1})), HasSubstr("run leaves"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 8\n" + bytesOf({2, 2, 0, 8, 0, 1})), HasSubstr("run leaves"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 3\n" + bytesOf({1, 1, 1, 3})), HasSubstr("run leaves"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 +X 3\n" + pixel(9, 9, 9) + bytesOf({1, 1, 1, 3})),
                HasSubstr("run leaves"));
    EXPECT_THAT(hdrError("#?RADIANCE\nFORMAT=8-bit\n\n-Y 1 +X 1\n"), HasSubstr("FORMAT=8-bit"));
    EXPECT_THAT(hdrError(kRgbe + "\nY 1 X 1\n"), HasSubstr("-Y 480 +X 640"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 1 -Y 1\n"), HasSubstr("-Y 480 +X 640"));
    EXPECT_THAT(hdrError(kRgbe + "\n-Y 0 +X 1\n"), HasSubstr("1 x 0"));
    EXPECT_THAT(hdrError(kRgbe), HasSubstr("header"));
    EXPECT_THAT(hdrError(kRgbe + "EXPOSURE=1e300\n\n-Y 1 +X 1\n" + pixel(1, 1, 1)),
                HasSubstr("out of range"));
}

TEST(Hdr, TheWriterRoundsToTheNearestValue) {
    RgbImage image = test::gradient(40, 30, 50.0f);
    const RgbImage read = decode(image::encodeHdr(image));
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Rgb& pixel = image.pixels[i];
        const float largest = std::max({pixel.x, pixel.y, pixel.z});
        int exponent;
        std::frexp(largest, &exponent);
        for (int c = 0; c < 3; ++c) {
            // Half a step; a whole one where rounding up the largest channel doubles the step.
            const float step = std::ldexp(1.0f, exponent - 8);
            EXPECT_NEAR(read.pixels[i][c], pixel[c], step * (largest > 255.5f * step ? 1.0f : 0.5f));
            sum += (read.pixels[i][c] - pixel[c]) / step;
        }
    }
    // Without bias: 3600 errors of a standard deviation of 0.29 steps.
    EXPECT_LT(std::abs(sum / 3600.0), 4.0 * 0.29 / 60.0);
}

TEST(Hdr, TheWriterHandlesEveryFloatAndWidth) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    RgbImage image(1, 1);
    const auto written = [&](Rgb color) {
        image.at(0, 0) = color;
        return decode(image::encodeHdr(image)).at(0, 0);
    };
    constexpr float kLargest = 255.0f * 0x1p119f;
    EXPECT_EQ(written({kInfinity, -1.0f, std::numeric_limits<float>::quiet_NaN()}),
              Rgb(kLargest, 0.0f, 0.0f));
    EXPECT_EQ(written({std::numeric_limits<float>::max(), 0x1p126f, 0.0f}), Rgb(kLargest, 0x1p126f, 0.0f));
    EXPECT_EQ(written({0x1p-140f, 0.0f, 0.0f}), Rgb(0.0f));
    EXPECT_EQ(written({0x1p-128f, 0x1p-128f, 0x1p-128f}), Rgb(0x1p-128f));
    EXPECT_EQ(written({255.9f, 1.0f, 0.0f}), Rgb(256.0f, 2.0f, 0.0f));
    for (const int width : {1, 7, 8, 127, 128, 129, 400, 32767, 32768}) {
        RgbImage row(width, 2);
        for (int x = 0; x < width; ++x)
            row.at(x, 0) = row.at(x, 1) = Rgb(1.0f, x / 7 % 2 ? 0.5f : 0.25f, x % 2 ? 1.0f : 0.5f);
        EXPECT_EQ(decode(image::encodeHdr(row)).pixels, row.pixels) << width;
    }
}

}  // namespace
}  // namespace rayscope
