#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>
#include <stb_image_write.h>

#include <bit>
#include <cmath>
#include <limits>

#include "image/srgb.h"
#include "image/test_images.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::decode;
using test::gradient;
using test::stbFile;
using test::TemporaryFolder;

void expectSameBits(const RgbImage& a, const RgbImage& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(std::bit_cast<std::uint32_t>(a.pixels[i][c]),
                      std::bit_cast<std::uint32_t>(b.pixels[i][c]))
                << "pixel " << i << " channel " << c;
}

RgbImage writtenAndRead(const RgbImage& image, const char* name) {
    const TemporaryFolder folder;
    writeImage(folder.file(name), image);
    return readImage(folder.file(name));
}

TEST(RoundTrip, LinearFormatsKeepEveryBit) {
    RgbImage image = gradient(7, 5, 1000.0f);
    image.at(0, 0) =
        Rgb(std::numeric_limits<float>::infinity(), -1.5f, std::numeric_limits<float>::denorm_min());
    image.at(6, 4) = Rgb(std::numeric_limits<float>::quiet_NaN(), -0.0f, std::numeric_limits<float>::max());
    expectSameBits(writtenAndRead(image, "a.exr"), image);
    expectSameBits(writtenAndRead(image, "a.pfm"), image);
}

TEST(RoundTrip, OnePixelIsEnough) {
    const RgbImage image(1, 1, Rgb(0.25f, 0.5f, 1.0f));
    for (const char* name : {"a.exr", "a.pfm", "a.hdr"}) expectSameBits(writtenAndRead(image, name), image);
    EXPECT_EQ(writtenAndRead(image, "a.png").width, 1);
}

TEST(RoundTrip, PngHoldsSrgbCodes) {
    const RgbImage image = gradient(13, 6);
    const RgbImage read = writtenAndRead(image, "a.PNG");
    ASSERT_EQ(read.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(read.pixels[i][c],
                      image::decodeByte(image::encodeByte(image.pixels[i][c], Encoding::Srgb)));
}

TEST(RoundTrip, PngWithoutEncodingHoldsTruncatedValues) {
    const TemporaryFolder folder;
    writeImage(folder.file("a.png"), RgbImage(2, 2, Rgb(0.5f)), {}, Encoding::None);
    EXPECT_EQ(readImage(folder.file("a.png")).at(1, 1).x, image::decodeByte(127));
}

TEST(RoundTrip, NonFinitePixelsOfAPngDoNotAffectNeighbours) {
    RgbImage image(3, 1, Rgb(0.5f));
    image.at(1, 0) =
        Rgb(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f);
    const RgbImage read = writtenAndRead(image, "a.png");
    EXPECT_EQ(read.at(1, 0), Rgb(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(read.at(0, 0), read.at(2, 0));
    EXPECT_EQ(read.at(0, 0), Rgb(image::decodeByte(188)));
}

TEST(Read, EightBitFormatsDecodeToTheSameValues) {
    const std::string codes = test::allCodes();
    const std::string bmp = stbFile(
        [&](auto* write, void* file) { stbi_write_bmp_to_func(write, file, 16, 16, 3, codes.data()); });
    const std::string tga = stbFile(
        [&](auto* write, void* file) { stbi_write_tga_to_func(write, file, 16, 16, 3, codes.data()); });
    const std::string png = stbFile(
        [&](auto* write, void* file) { stbi_write_png_to_func(write, file, 16, 16, 3, codes.data(), 48); });
    for (const std::string& file : {bmp, tga, png}) {
        const RgbImage image = decode(file);
        ASSERT_EQ(image.pixels.size(), 256u);
        for (int code = 0; code < 256; ++code)
            EXPECT_EQ(image.at(code % 16, code / 16),
                      Rgb(image::decodeByte(static_cast<std::uint8_t>(code))));
    }
}

TEST(Read, JpegIsClose) {
    const std::string codes = test::allCodes();
    const RgbImage image = decode(stbFile(
        [&](auto* write, void* file) { stbi_write_jpg_to_func(write, file, 16, 16, 3, codes.data(), 100); }));
    ASSERT_EQ(image.pixels.size(), 256u);
    for (int code = 0; code < 256; ++code)
        EXPECT_NEAR(image::encodeByte(image.at(code % 16, code / 16).y, Encoding::Srgb), code, 3);
}

TEST(Read, AlphaIsIgnoredAndGreyFillsAllChannels) {
    const unsigned char greyAndAlpha[]{100, 7, 200, 255};
    const RgbImage image = decode(stbFile(
        [&](auto* write, void* file) { stbi_write_png_to_func(write, file, 2, 1, 2, greyAndAlpha, 4); }));
    EXPECT_EQ(image.at(0, 0), Rgb(image::decodeByte(100)));
    EXPECT_EQ(image.at(1, 0), Rgb(image::decodeByte(200)));
}

TEST(Read, PfmOfEitherByteOrderScaleAndChannelCount) {
    const std::string one("\x3f\x80\x00\x00", 4), oneSwapped("\x00\x00\x80\x3f", 4);
    EXPECT_EQ(decode("PF\n1 1\n1.0\n" + one + one + one).at(0, 0), Rgb(1.0f));
    EXPECT_EQ(decode("PF\n1 1\n-1.0\n" + oneSwapped + oneSwapped + oneSwapped).at(0, 0), Rgb(1.0f));
    EXPECT_EQ(decode("Pf 1 1 2.5\n" + one).at(0, 0), Rgb(2.5f));
}

TEST(Read, PfmRowsGoUp) {
    const std::string one("\x3f\x80\x00\x00", 4), zero(4, '\0');
    const RgbImage image = decode("Pf\n1 2\n1\n" + one + zero);
    EXPECT_EQ(image.at(0, 0), Rgb(0.0f));
    EXPECT_EQ(image.at(0, 1), Rgb(1.0f));
}

TEST(Read, ExrWithLuminanceOnlyAndADataWindowElsewhere) {
    const TemporaryFolder folder;
    const std::string path = folder.file("y.exr");
    const float values[]{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
    {
        const Imath::Box2i window({-100, 50}, {-98, 51});
        Imf::Header header(window, window);
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        Imf::OutputFile output(path.c_str(), header);
        Imf::FrameBuffer buffer;
        const auto origin =
            reinterpret_cast<std::intptr_t>(values) - (50 * 3 - 100) * std::intptr_t{sizeof(float)};
        buffer.insert(
            "Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(origin), sizeof(float), 3 * sizeof(float)));
        output.setFrameBuffer(buffer);
        output.writePixels(2);
    }
    const RgbImage image = readImage(path);
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 2);
    EXPECT_EQ(image.at(0, 0), Rgb(1.0f));
    EXPECT_EQ(image.at(2, 1), Rgb(6.0f));
}

}  // namespace
}  // namespace rayscope
