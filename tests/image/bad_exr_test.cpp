// Damaged EXR files: refused by name, never read from memory that the file did not fill.
#include <ImfPreviewImage.h>
#include <gmock/gmock.h>
#include <malloc.h>

#include <cstring>

#include "image/exr_files.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using test::ExrWriter;
using test::inputErrorOf;
using testing::AllOf;
using testing::HasSubstr;

RgbImage decodedBadExr(const std::string& file) {
    return image::decodeExr(std::as_bytes(std::span(file)), "x.exr");
}
std::string badExrError(const std::string& file) {
    return inputErrorOf([&] { decodedBadExr(file); });
}

float pixelAt(const std::string& channel, int x, int y) {
    return static_cast<float>(channel[0]) + static_cast<float>(x * y % 7);
}

std::string fileWith(Imf::Compression compression, bool tiled = false) {
    ExrWriter writer(40, 33);
    writer.header.compression() = compression;
    if (!tiled) return writer.scanLines(pixelAt);
    writer.header.setTileDescription({16, 16, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    return writer.tiles(pixelAt);
}

std::size_t endOf(const std::string& file, const std::string& attribute, const std::string& type) {
    const std::string start = attribute + '\0' + type + '\0';
    return file.find(start) + start.size();
}

/// Position of the first block: the first entry of the table behind the header.
std::size_t tableOf(const std::string& file) {
    // The attributes are in alphabetical order, and "type" or "tiles" may follow this one: search the end.
    std::size_t at = endOf(file, "screenWindowWidth", "float") + 8;
    while (file[at] != '\0') {
        at = file.find('\0', at) + 1;
        at = file.find('\0', at) + 1;
        std::int32_t size;
        std::memcpy(&size, file.data() + at, 4);
        at += 4 + static_cast<std::size_t>(size);
    }
    return at + 1;
}
std::uint64_t firstBlock(const std::string& file) {
    std::uint64_t offset;
    std::memcpy(&offset, file.data() + tableOf(file), 8);
    return offset;
}

TEST(BadExr, BlocksThatHoldTooLittleAreRefused) {
    for (const bool tiled : {false, true})
        for (const Imf::Compression compression :
             {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
              Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::DWAA_COMPRESSION}) {
            std::string file = fileWith(compression, tiled);
            ASSERT_NO_THROW(decodedBadExr(file));
            // An empty block, which the library takes as read.
            const std::uint32_t nothing = 0;
            std::memcpy(file.data() + firstBlock(file) + (tiled ? 16 : 4), &nothing, 4);
            EXPECT_THAT(badExrError(file), AllOf(HasSubstr("x.exr"), HasSubstr("block at pixel 0, 0")))
                << compression;
        }
}

TEST(BadExr, TablesAndOffsetsAreChecked) {
    for (const bool tiled : {false, true}) {
        const std::string file = fileWith(Imf::ZIP_COMPRESSION, tiled);
        std::string changed = file;
        changed.replace(tableOf(file), 8, 8, '\0');
        EXPECT_THAT(badExrError(changed), HasSubstr("incomplete"));
        changed.replace(tableOf(file), 8, 8, '\x7f');
        EXPECT_THAT(badExrError(changed), HasSubstr("behind the end"));
        changed = file;
        const std::uint64_t shifted = firstBlock(file) + 4;
        std::memcpy(changed.data() + tableOf(file), &shifted, 8);
        EXPECT_NE(badExrError(changed), "");
        EXPECT_THAT(badExrError(file.substr(0, tableOf(file) + 5)), HasSubstr("table of blocks"));
    }
}

TEST(BadExr, AnnouncedSizesAreComparedWithTheFile) {
    const std::string file = fileWith(Imf::ZIP_COMPRESSION);
    std::string changed = file;
    changed.replace(endOf(file, "lineOrder", "lineOrder"), 4, "\xff\xff\xff\x7f", 4);
    EXPECT_THAT(badExrError(changed), AllOf(HasSubstr("'lineOrder'"), HasSubstr("2147483647 bytes")));
    changed.replace(endOf(file, "lineOrder", "lineOrder"), 4, "\xff\xff\xff\xff", 4);
    EXPECT_THAT(badExrError(changed), HasSubstr("-1 bytes"));

    ExrWriter writer(4, 4);
    writer.header.setPreviewImage(Imf::PreviewImage(2, 2));
    changed = writer.scanLines(pixelAt);
    ASSERT_NO_THROW(decodedBadExr(changed));
    changed.replace(endOf(changed, "preview", "preview") + 4, 8, "\x30\x75\0\0\x30\x75\0\0", 8);
    EXPECT_THAT(badExrError(changed), HasSubstr("30000 x 30000"));

    changed = file;
    changed[endOf(file, "compression", "compression") + 4] = 77;
    EXPECT_THAT(badExrError(changed), HasSubstr("compression method 77"));
}

/// The pixels, or the error.
std::string outcomeOf(const std::string& file) {
    try {
        const RgbImage image = decodedBadExr(file);
        return {reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(Rgb)};
    } catch (const InputError& error) {
        return error.what();
    }
}

/// A picture is a function of the file: glibc fills new memory with the given byte.
TEST(BadExr, PicturesDoNotDependOnTheHeap) {
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const bool tiled : {false, true}) {
            const std::string file = fileWith(static_cast<Imf::Compression>(compression), tiled);
            const std::size_t start = tableOf(file);
            for (std::size_t at = start; at < file.size(); at += 1 + (file.size() - start) / 150) {
                std::string damaged = file;
                damaged[at] = static_cast<char>(damaged[at] ^ (at % 2 ? 0xff : 0x10));
                ::mallopt(M_PERTURB, 0x11);
                const std::string first = outcomeOf(damaged);
                ::mallopt(M_PERTURB, 0xa5);
                const std::string second = outcomeOf(damaged);
                ::mallopt(M_PERTURB, 0);
                EXPECT_TRUE(first == second) << "compression " << compression << ", byte " << at;
            }
        }
}

}  // namespace
}  // namespace rayscope
