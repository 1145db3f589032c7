#include <rayscope/image.h>
#include <stb_image_write.h>
#include <sys/resource.h>

#include <csignal>

#include "image/codecs/codecs.h"
#include "image/test_images.h"
#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::decode;
using test::gradient;
using test::inputErrorOf;
using test::readText;
using test::stbFile;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

std::string errorOfDecoding(const std::string& file) {
    return inputErrorOf([&] { decode(file, "x.img"); });
}

/// The same image in every format that can be read.
std::vector<std::pair<std::string, std::string>> allFormats() {
    const RgbImage image = gradient(16, 16);
    const std::string codes = test::allCodes();
    const char* data = codes.data();
    return {{"png", image::encodePng(image, {}, Encoding::Srgb)},
            {"exr", image::encodeExr(image, {})},
            {"pfm", image::encodePfm(image)},
            {"hdr", image::encodeHdr(image)},
            {"bmp",
             stbFile([&](auto* write, void* file) { stbi_write_bmp_to_func(write, file, 16, 16, 3, data); })},
            {"tga",
             stbFile([&](auto* write, void* file) { stbi_write_tga_to_func(write, file, 16, 16, 3, data); })},
            {"jpg", stbFile([&](auto* write, void* file) {
                 stbi_write_jpg_to_func(write, file, 16, 16, 3, data, 90);
             })}};
}

TEST(BadImage, UnreadableFilesAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.file("none.png")); }),
                AllOf(HasSubstr("none.png"), HasSubstr("No such file")));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.path().string()); }), HasSubstr("is a folder"));
    EXPECT_THAT(inputErrorOf([] { readImage("/dev/zero"); }), HasSubstr("is a device"));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.write("empty.png", "")); }),
                AllOf(HasSubstr("empty.png"), HasSubstr("0 bytes")));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.write("text.png", "plain text\n")); }),
                AllOf(HasSubstr("text.png"), HasSubstr("expected PNG, JPEG")));
}

TEST(BadImage, TruncatedFilesAreErrors) {
    for (const auto& [kind, file] : allFormats()) {
        ASSERT_EQ(decode(file).pixels.size(), 256u) << kind;
        // TGA may end in a footer of 26 bytes without which the image is whole; the end marker of a JPEG has
        // 2 bytes.
        const std::size_t needed = file.size() - (kind == "tga" ? 27 : kind == "jpg" ? 3 : 0);
        for (std::size_t length = 1; length < needed; length += 1 + length / 16)
            EXPECT_NE(errorOfDecoding(file.substr(0, length)), "")
                << kind << " cut to " << length << " bytes";
    }
}

TEST(BadImage, AnInvertedByteNeverCrashesADecoder) {
    for (const auto& [kind, file] : allFormats()) {
        for (std::size_t at = 0; at < std::min<std::size_t>(file.size(), 400); ++at) {
            std::string damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
            try {
                const RgbImage image = decode(damaged);
                EXPECT_EQ(image.pixels.size(),
                          static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
                EXPECT_LE(static_cast<long long>(image.pixels.size()), kMaxImagePixels);
            } catch (const InputError& error) {
                EXPECT_THAT(error.what(), HasSubstr("memory")) << kind << " byte " << at;
            }
        }
    }
}

/// Offset of the width and height, 4 bytes each, in a PNG file.
constexpr std::size_t kWidthInPng = 16;

TEST(BadImage, ASizeAboveTheLimitIsAnErrorBeforePixelsAreAllocated) {
    std::string png = image::encodePng(gradient(1, 1), {}, Encoding::Srgb);
    const std::string size("\0\0\x42\x68", 4);
    png.replace(kWidthInPng, 8, size + size);
    for (const std::string& file : {png, std::string("PF\n17000 17000\n-1\n")})
        EXPECT_THAT(errorOfDecoding(file), AllOf(HasSubstr("x.img"), HasSubstr("17000 x 17000 pixels"),
                                                 HasSubstr("268435456"), HasSubstr("scale it down")));
    EXPECT_THAT(errorOfDecoding("PF\n2147483647 2147483647\n-1\n"), HasSubstr("limit"));
}

TEST(BadImage, ASizeThatTheFileCannotHoldIsAnErrorBeforePixelsAreAllocated) {
    std::string png = image::encodePng(gradient(1, 1), {}, Encoding::Srgb);
    const std::string size("\0\0\x3e\x80", 4);
    png.replace(kWidthInPng, 8, size + size);
    EXPECT_THAT(errorOfDecoding(png),
                AllOf(HasSubstr("damaged"), HasSubstr("16000 x 16000 pixels in a file")));
}

TEST(BadImage, TheDensestFilesAreRead) {
    // One colour over many pixels: no codec compresses better.
    const RgbImage grey(2000, 2000, Rgb(0.5f));
    for (const std::string& file : {image::encodePng(grey, {}, Encoding::Srgb), image::encodeExr(grey, {})})
        EXPECT_EQ(decode(file).pixels.size(), grey.pixels.size());
}

TEST(BadImage, ExrWithAHugeWindowIsAnError) {
    std::string exr = image::encodeExr(gradient(2, 2), {});
    const std::string attribute = std::string("dataWindow") + '\0' + "box2i" + '\0';
    const std::size_t maximum =
        exr.find(attribute) + attribute.size() + 4 + 8;      // after the length and the minimum
    const std::string maximumCoordinate("\x67\x42\0\0", 4);  // 16999
    exr.replace(maximum, 8, maximumCoordinate + maximumCoordinate);
    EXPECT_THAT(errorOfDecoding(exr), AllOf(HasSubstr("17000 x 17000"), HasSubstr("limit")));
}

TEST(BadImage, ErrorsNameTheWrongFieldOfAPfmHeader) {
    EXPECT_THAT(errorOfDecoding("PF\nten 10\n-1\n"), HasSubstr("width"));
    EXPECT_THAT(errorOfDecoding("PF\n10\n"), HasSubstr("height"));
    EXPECT_THAT(errorOfDecoding("PF\n10 10\n0\n"), HasSubstr("scale"));
    EXPECT_THAT(errorOfDecoding("PF\n-3 10\n1\n"), HasSubstr("-3 x 10"));
}

TEST(BadOutput, UnknownSuffixesAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { checkImageDestination(folder.file("a.pgn")); }),
                AllOf(HasSubstr(".png, .exr, .pfm, .hdr, .ppm or .pgm"), HasSubstr("did you mean '.png'")));
    EXPECT_THAT(inputErrorOf([&] { writeImage(folder.file("png"), gradient(1, 1)); }),
                HasSubstr("unknown image format"));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(BadOutput, MissingFoldersAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { checkImageDestination(folder.file("no/a.png")); }),
                AllOf(HasSubstr(folder.file("no")), HasSubstr("create it")));
    EXPECT_THAT(inputErrorOf([&] { writeImage(folder.file("a.png"), RgbImage()); }), HasSubstr("no pixels"));
}

TEST(BadOutput, AFullDiskLeavesTheOldImage) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    writeImage(path, gradient(4, 4));
    const std::string old = readText(path);

    auto* const oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{100, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = inputErrorOf([&] { writeImage(path, gradient(64, 64)); });
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, oldHandler);

    EXPECT_THAT(message, AllOf(HasSubstr("a.exr"), HasSubstr("cannot be written")));
    EXPECT_EQ(readText(path), old);
    EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace rayscope
