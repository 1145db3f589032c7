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

/// One file of each kind that can be read, of the same picture.
std::vector<std::pair<std::string, std::string>> oneOfEach() {
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

TEST(BadImage, WrongNamesAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.file("none.png")); }),
                AllOf(HasSubstr("none.png"), HasSubstr("No such file")));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.path().string()); }), HasSubstr("is a folder"));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.write("empty.png", "")); }),
                AllOf(HasSubstr("empty.png"), HasSubstr("0 bytes")));
    EXPECT_THAT(inputErrorOf([&] { readImage(folder.write("text.png", "Dear Sir or Madam,\n")); }),
                AllOf(HasSubstr("text.png"), HasSubstr("expected PNG, JPEG")));
}

TEST(BadImage, AFileThatIsCutShortIsNeverAnImage) {
    for (const auto& [kind, file] : oneOfEach()) {
        ASSERT_EQ(decode(file).pixels.size(), 256u) << kind;
        // TGA may end in a footer of 26 bytes without which the image is whole; the end marker of a JPEG has
        // 2 bytes.
        const std::size_t needed = file.size() - (kind == "tga" ? 27 : kind == "jpg" ? 3 : 0);
        for (std::size_t length = 1; length < needed; length += 1 + length / 16)
            EXPECT_NE(errorOfDecoding(file.substr(0, length)), "")
                << kind << " cut to " << length << " bytes";
    }
}

TEST(BadImage, NoSingleWrongByteBringsAReaderDown) {
    for (const auto& [kind, file] : oneOfEach()) {
        for (std::size_t at = 0; at < std::min<std::size_t>(file.size(), 400); ++at) {
            std::string damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
            try {
                const RgbImage image = decode(damaged);
                EXPECT_LE(static_cast<long long>(image.pixels.size()), kMaxImagePixels);
            } catch (const InputError&) {
            }
        }
    }
}

TEST(BadImage, ASizeAboveTheLimitIsRefusedBeforeAnythingIsAllocated) {
    std::string png = image::encodePng(gradient(1, 1), {}, Encoding::Srgb);
    constexpr std::size_t kWidthInPng = 16;
    const std::string tenThousand("\0\0\x27\x10", 4);
    png.replace(kWidthInPng, 8, tenThousand + tenThousand);
    for (const std::string& file : {png, std::string("PF\n10000 10000\n-1\n")})
        EXPECT_THAT(errorOfDecoding(file), AllOf(HasSubstr("x.img"), HasSubstr("10000 x 10000 pixels"),
                                                 HasSubstr("67108864"), HasSubstr("scale it down")));
    EXPECT_THAT(errorOfDecoding("PF\n2147483647 2147483647\n-1\n"), HasSubstr("limit"));
}

TEST(BadImage, ExrWithAHugeWindowIsRefused) {
    std::string exr = image::encodeExr(gradient(2, 2), {});
    const std::string attribute = std::string("dataWindow") + '\0' + "box2i" + '\0';
    const std::size_t maximum =
        exr.find(attribute) + attribute.size() + 4 + 8;  // after the length and the minimum
    const std::string tenThousandLess1("\x0f\x27\0\0", 4);
    exr.replace(maximum, 8, tenThousandLess1 + tenThousandLess1);
    EXPECT_THAT(errorOfDecoding(exr), AllOf(HasSubstr("10000 x 10000"), HasSubstr("limit")));
}

TEST(BadImage, PfmHeadersSayWhatIsMissing) {
    EXPECT_THAT(errorOfDecoding("PF\nten 10\n-1\n"), HasSubstr("width"));
    EXPECT_THAT(errorOfDecoding("PF\n10\n"), HasSubstr("height"));
    EXPECT_THAT(errorOfDecoding("PF\n10 10\n0\n"), HasSubstr("scale"));
    EXPECT_THAT(errorOfDecoding("PF\n-3 10\n1\n"), HasSubstr("-3 x 10"));
}

TEST(BadOutput, UnknownSuffixesAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { checkImageDestination(folder.file("a.pgn")); }),
                AllOf(HasSubstr(".png, .exr, .pfm or .hdr"), HasSubstr("did you mean '.png'")));
    EXPECT_THAT(inputErrorOf([&] { writeImage(folder.file("png"), gradient(1, 1)); }),
                HasSubstr("should end in"));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(BadOutput, AFolderThatIsMissingIsNamed) {
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
