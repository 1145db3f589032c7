#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>
#include <stb_image.h>

// jpeglib.h needs the types of the next header.
#include <cstdio>

#include <jpeglib.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>

#include "image/srgb.h"
#include "image/test_images.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bytesOf;
using test::decode;
using test::notesOf;
using testing::AllOf;
using testing::HasSubstr;

std::string jpegError(const std::string& file) {
    return test::inputErrorOf([&] { decode(file, "x.jpg"); });
}

constexpr int kWidth = 37, kHeight = 21;

/// A smooth sample, 0 … 255.
std::uint8_t sampleAt(int x, int y, int channel) {
    return static_cast<std::uint8_t>(128.0 + 100.0 * std::sin(0.05 * x + 0.03 * y * (channel + 1) + channel));
}

using Options = std::function<void(jpeg_compress_struct&)>;

/// A file of smooth samples with 1, 3 or 4 channels.
std::string jpegFile(int channels, const Options& options = {}, bool inverted = false) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = kWidth;
    jpeg.image_height = kHeight;
    jpeg.input_components = channels;
    jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (options) options(jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < kHeight; ++y) {
        std::vector<JSAMPLE> row;
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < channels; ++c)
                row.push_back(static_cast<JSAMPLE>(inverted ? 255 - sampleAt(x, y, c) : sampleAt(x, y, c)));
        JSAMPLE* rows = row.data();
        jpeg_write_scanlines(&jpeg, &rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return file;
}

int codeOf(float linear) { return image::encodeByte(linear, Encoding::Srgb); }

void expectSamples(const RgbImage& image, int channels, int tolerance) {
    ASSERT_EQ(image.width, kWidth);
    ASSERT_EQ(image.height, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(codeOf(image.at(x, y)[c]), sampleAt(x, y, channels == 1 ? 0 : c), tolerance)
                    << x << "," << y;
}

/// Marker segments behind the start of the image.
std::string withSegment(const std::string& file, int marker, const std::string& data) {
    return file.substr(0, 2) + bytesOf({0xff, marker}) +
           test::bigEndian(static_cast<std::uint32_t>(data.size() + 2), 2) + data + file.substr(2);
}

void setSampling(jpeg_compress_struct& jpeg, int horizontal, int vertical) {
    jpeg.comp_info[0].h_samp_factor = horizontal;
    jpeg.comp_info[0].v_samp_factor = vertical;
}

TEST(Jpeg, EveryCodingThatIsRead) {
    const Options kCodings[]{
        [](auto&) {},
        [](auto& jpeg) { jpeg_simple_progression(&jpeg); },
        [](auto& jpeg) { jpeg.arith_code = TRUE; },
        [](auto& jpeg) { jpeg.arith_code = TRUE, jpeg_simple_progression(&jpeg); },
        [](auto& jpeg) { jpeg.restart_interval = 2; },
        [](auto& jpeg) { jpeg.optimize_coding = TRUE; },
        [](auto& jpeg) { jpeg_set_colorspace(&jpeg, JCS_RGB); },
    };
    for (const auto& coding : kCodings) {
        const std::string file = jpegFile(3, [&](auto& jpeg) {
            setSampling(jpeg, 1, 1);
            coding(jpeg);
        });
        expectSamples(decode(file), 3, 5);
        EXPECT_EQ(notesOf(file), "");
    }
    for (const auto& [horizontal, vertical] : {std::pair{2, 1}, {1, 2}, {2, 2}, {4, 1}, {4, 2}})
        expectSamples(decode(jpegFile(3, [&](auto& jpeg) { setSampling(jpeg, horizontal, vertical); })), 3,
                      24);
    expectSamples(decode(jpegFile(1)), 1, 2);
    expectSamples(decode(jpegFile(1, [](auto& jpeg) { jpeg_simple_progression(&jpeg); })), 1, 2);
}

TEST(Jpeg, AnotherDecoderAgrees) {
    for (const bool progressive : {false, true}) {
        const std::string file = jpegFile(3, [&](auto& jpeg) {
            if (progressive) jpeg_simple_progression(&jpeg);
        });
        int width, height, channels;
        const std::unique_ptr<stbi_uc, void (*)(void*)> samples(
            stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()),
                                  static_cast<int>(file.size()), &width, &height, &channels, 3),
            stbi_image_free);
        const RgbImage image = decode(file);
        ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(width * height));
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(codeOf(image.pixels[i][c]), samples.get()[3 * i + static_cast<std::size_t>(c)],
                            3);
    }
}

TEST(Jpeg, InksOfBothConventions) {
    const auto adobe = [](J_COLOR_SPACE space) {
        return [space](jpeg_compress_struct& jpeg) { jpeg_set_colorspace(&jpeg, space); };
    };
    // libjpeg writes the marker of Adobe for both spaces; then inks are inverted.
    const std::string cmyk = jpegFile(4, adobe(JCS_CMYK)), ycck = jpegFile(4, adobe(JCS_YCCK));
    std::string plain = jpegFile(4, adobe(JCS_CMYK), true);
    const std::size_t marker = plain.find("\xff\xee");
    plain.erase(marker, 16);
    for (const std::string& file : {cmyk, ycck, plain}) {
        const RgbImage image = decode(file);
        for (const auto& [x, y] : {std::pair{3, 4}, {20, 11}, {36, 20}})
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(codeOf(image.at(x, y)[c]), sampleAt(x, y, c) * sampleAt(x, y, 3) / 255, 8);
        EXPECT_THAT(notesOf(file), HasSubstr("CMYK"));
    }
}

/// The file with the marker of its frame replaced.
std::string withFrame(int marker) {
    std::string file = jpegFile(1);
    file[file.find("\xff\xc0") + 1] = static_cast<char>(marker);
    return file;
}

TEST(Jpeg, CodingsThatAreNotReadAreNamed) {
    EXPECT_THAT(jpegError(withFrame(0xc3)), HasSubstr("lossless coding"));
    EXPECT_THAT(jpegError(withFrame(0xcb)), HasSubstr("lossless arithmetic coding"));
    for (const int marker : {0xc5, 0xc6, 0xc7, 0xcd, 0xce, 0xcf})
        EXPECT_THAT(jpegError(withFrame(marker)), HasSubstr("hierarchical coding"));
    std::string file = withFrame(0xc1);
    const std::size_t frame = file.find("\xff\xc1");
    file[frame + 4] = 12;
    EXPECT_THAT(jpegError(file), HasSubstr("12 bits per sample"));
    file[frame + 4] = 8;
    file.replace(frame + 5, 2, 2, '\0');
    EXPECT_THAT(jpegError(file), HasSubstr("DNL"));
    file.replace(frame + 5, 4, "\xff\xff\xff\xff");
    EXPECT_THAT(jpegError(file), HasSubstr("65535 x 65535 pixels, the limit"));
    file.replace(frame + 5, 4, "\x20\x01\x20\x01");
    EXPECT_THAT(jpegError(file), HasSubstr("8193 x 8193 pixels in a file of"));
    EXPECT_THAT(jpegError(bytesOf({0xff, 0xd8, 0xff, 0xf7, 0, 4, 8, 0})), HasSubstr("JPEG-LS"));
    // Sampling factors of 3 and 2.
    std::string fractional = jpegFile(3);
    const std::size_t components = fractional.find("\xff\xc0") + 10;
    fractional[components + 1] = 0x31;
    fractional[components + 4] = 0x21;
    EXPECT_THAT(jpegError(fractional), HasSubstr("a feature that is not read (Fractional sampling"));
}

TEST(Jpeg, IncompleteFilesAreDamaged) {
    const std::string grey = jpegFile(1), end = bytesOf({0xff, 0xd9});
    const std::size_t scan = grey.find("\xff\xda");
    EXPECT_THAT(jpegError(grey.substr(0, scan) + end), HasSubstr("before the first scan"));
    EXPECT_THAT(jpegError(grey.substr(0, 2) + end), HasSubstr("no frame header"));
    EXPECT_THAT(jpegError(grey.substr(0, scan + 20) + end), HasSubstr("premature end"));
    EXPECT_THAT(jpegError(grey.substr(0, scan + 20)), HasSubstr("damaged"));
    EXPECT_THAT(notesOf(grey.substr(0, grey.size() - 2)), HasSubstr("end marker"));
    const std::string progressive = jpegFile(3, [](auto& jpeg) { jpeg_simple_progression(&jpeg); });
    const std::size_t secondScan = progressive.find("\xff\xda", progressive.find("\xff\xda") + 1);
    EXPECT_THAT(jpegError(progressive.substr(0, secondScan)), HasSubstr("unexpected end of file"));
    // A scan for each component, of which the last is missing.
    const std::string separate = jpegFile(3, [](auto& jpeg) {
        static constexpr jpeg_scan_info kScans[]{
            {1, {0}, 0, 63, 0, 0}, {1, {1}, 0, 63, 0, 0}, {1, {2}, 0, 63, 0, 0}};
        jpeg.scan_info = kScans;
        jpeg.num_scans = 3;
    });
    expectSamples(decode(separate), 3, 24);
    EXPECT_THAT(jpegError(separate.substr(0, separate.rfind("\xff\xda")) + end),
                HasSubstr("no scan of component 3"));
}

TEST(Jpeg, WhatIsIgnoredIsReported) {
    const std::string file = jpegFile(1);
    const std::string exif = "Exif\0\0II*\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0\6\0\0\0\0\0\0\0"s;
    EXPECT_THAT(notesOf(withSegment(file, 0xe1, exif)),
                AllOf(HasSubstr("warning"), HasSubstr("EXIF orientation")));
    std::string upright = exif;
    upright[upright.find('\6')] = 1;
    EXPECT_EQ(notesOf(withSegment(file, 0xe1, upright)), "");
    EXPECT_THAT(notesOf(withSegment(file, 0xe2, "ICC_PROFILE\0\1\1 Display P3"s)), HasSubstr("ICC profile"));
    EXPECT_EQ(notesOf(withSegment(file, 0xe2, "ICC_PROFILE\0\1\1 sRGB IEC61966-2.1"s)), "");
    EXPECT_EQ(notesOf(file + "a second image"), "");
}

}  // namespace
}  // namespace rayscope
