// Damaged files: decoders never crash, and what they return depends on the file alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <rayscope/image.h>
#include <stb_image_write.h>

#include <cstring>
#include <functional>
#include <memory>
#include <random>

#include "image/codecs/codecs.h"
#include "image/test_images.h"

namespace rayscope {
namespace {

using test::bytesOf;
using test::decode;
using test::gradient;
using test::littleEndian;
using test::stbFile;

std::string runLengthBmp() {
    std::string palette;
    for (int i = 0; i < 16; ++i) palette += bytesOf({i, i, i, 0});
    const std::string header = littleEndian(40, 4) + littleEndian(20, 4) + littleEndian(4, 4) +
                               littleEndian(1, 2) + littleEndian(8, 2) + littleEndian(1, 4) +
                               littleEndian(0, 12) + littleEndian(16, 4) + littleEndian(0, 4);
    std::string pixels;
    for (int row = 0; row < 4; ++row)
        pixels += bytesOf({9, row, 0, 5, 1, 2, 3, 4, 5, 0, 0, 2, 1, 0, 5, 7, 0, 0});
    return "BM" + littleEndian(0, 8) + littleEndian(14 + 40 + 64, 4) + header + palette + pixels +
           bytesOf({0, 1});
}

/// The same small images in every format, plain and with run-length code.
std::vector<std::pair<std::string, std::string>> files() {
    const RgbImage image = gradient(16, 12);
    const std::string codes = test::allCodes();
    const char* data = codes.data();
    const auto jpeg = [&](int quality) {
        return stbFile(
            [&](auto* write, void* file) { stbi_write_jpg_to_func(write, file, 16, 16, 3, data, quality); });
    };
    const auto tga = [&](bool runs) {
        stbi_write_tga_with_rle = runs;
        return stbFile(
            [&](auto* write, void* file) { stbi_write_tga_to_func(write, file, 16, 16, 3, data); });
    };
    std::string text = "P3\n16 16\n255\n";
    for (const char code : codes) text += std::to_string(static_cast<std::uint8_t>(code)) + " ";
    return {{"png", image::encodePng(image, {{"seed", "7"}}, Encoding::Srgb)},
            {"hdr", image::encodeHdr(image)},
            {"flat hdr", image::encodeHdr(gradient(7, 12))},
            {"pfm", image::encodePfm(image)},
            {"ppm", image::encodePpm(image, Encoding::Srgb)},
            {"text ppm", text},
            {"jpg", jpeg(90)},
            {"coarse jpg", jpeg(5)},
            {"bmp",
             stbFile([&](auto* write, void* file) { stbi_write_bmp_to_func(write, file, 16, 16, 3, data); })},
            {"run-length bmp", runLengthBmp()},
            {"tga", tga(false)},
            {"run-length tga", tga(true)}};
}

/// What decoding gives: the bits of the pixels, or the error.
std::string mutatedOutcome(const std::string& file) {
    try {
        const RgbImage image = decode(file);
        EXPECT_EQ(image.pixels.size(),
                  static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
        return {reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(Rgb)};
    } catch (const InputError& error) {
        return error.what();
    }
}

/// Fills the free stack and new and freed heap blocks with a pattern.
void dirtyMemory(int pattern) {
    ::mallopt(M_PERTURB, pattern);
    volatile unsigned char stack[1 << 15];
    for (volatile unsigned char& byte : stack) byte = static_cast<unsigned char>(pattern);
    for (std::size_t size = 16; size < (1u << 20); size *= 2) {
        const std::unique_ptr<unsigned char[]> block(new unsigned char[size]);
        std::memset(block.get(), pattern, size);
        asm volatile("" : : "r"(block.get()) : "memory");  // not optimized away
    }
}

void expectSameOutcome(const std::string& file, const std::string& what) {
    dirtyMemory(0x55);
    const std::string first = mutatedOutcome(file);
    dirtyMemory(0xc3);
    const std::string second = mutatedOutcome(file);
    ::mallopt(M_PERTURB, 0);
    ASSERT_TRUE(first == second) << what;
}

TEST(Mutation, WholeFilesAreRead) {
    for (const auto& [kind, file] : files()) EXPECT_GT(decode(file).pixels.size(), 70u) << kind;
}

TEST(Mutation, TheOutcomeForCutFilesDependsOnTheFileAlone) {
    for (const auto& [kind, file] : files())
        for (std::size_t length = 1; length < file.size(); length += 1 + file.size() / 500)
            expectSameOutcome(file.substr(0, length), kind + " cut to " + std::to_string(length));
}

TEST(Mutation, TheOutcomeForChangedFilesDependsOnTheFileAlone) {
    std::mt19937 random(11);
    for (const auto& [kind, file] : files())
        for (int i = 0; i < 2000; ++i) {
            std::string changed = file;
            for (unsigned n = random() % 4 + 1; n > 0; --n)
                changed[random() %
                        (random() % 2 ? changed.size() : std::min<std::size_t>(changed.size(), 64))] =
                    static_cast<char>(random() % 3 ? random() : 0xff);
            // Filling memory takes longer than decoding.
            if (i % 8 == 0)
                expectSameOutcome(changed, kind + " change " + std::to_string(i));
            else
                mutatedOutcome(changed);
        }
}

}  // namespace
}  // namespace rayscope
