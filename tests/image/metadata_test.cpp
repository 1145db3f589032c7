#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>

#include <vector>

#include "image/codecs/codecs.h"
#include "image/png_builder.h"
#include "image/test_images.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using namespace std::string_literals;
using test::bigEndianAt;
using test::gradient;

struct Chunk {
    std::string type, data;
};

std::vector<Chunk> chunksOf(const std::string& png) {
    std::vector<Chunk> chunks;
    constexpr std::size_t kSignature = 8;
    for (std::size_t at = kSignature; at + 12 <= png.size();) {
        const std::size_t length = bigEndianAt(png, at);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        at += 12 + length;
    }
    return chunks;
}

TEST(Metadata, PngHasTextChunksBeforeThePixels) {
    const std::string png = image::encodePng(
        gradient(5, 4), {{"seed", "7"}, {"scene", "K\u00fcche.toml"}, {"command", ""}}, Encoding::Srgb);
    const std::vector<Chunk> chunks = chunksOf(png);
    ASSERT_EQ(chunks.size(), 7u);
    EXPECT_EQ(chunks[0].type, "IHDR");
    EXPECT_EQ(chunks[1].type + chunks[1].data, "sRGB\0"s);
    EXPECT_EQ(chunks[2].type + chunks[2].data, "tEXtrayscope:command\0"s);
    EXPECT_EQ(chunks[3].type + chunks[3].data, "iTXtrayscope:scene\0\0\0\0\0K\u00fcche.toml"s);
    EXPECT_EQ(chunks[4].type + chunks[4].data,
              "tEXtrayscope:seed\0"
              "7"s);
    EXPECT_EQ(chunks[5].type, "IDAT");
    EXPECT_EQ(chunks[6].type, "IEND");
}

TEST(Metadata, EveryPngChunkHasItsChecksum) {
    const std::string png = image::encodePng(gradient(5, 4), {{"seed", "7"}}, Encoding::None);
    std::size_t at = 8;
    for (const Chunk& chunk : chunksOf(png)) {
        EXPECT_NE(chunk.type, "sRGB") << "the values are not sRGB-encoded";
        EXPECT_EQ(bigEndianAt(png, at + 8 + chunk.data.size()), test::bitwiseCrc(chunk.type + chunk.data))
            << chunk.type;
        at += 12 + chunk.data.size();
    }
    EXPECT_EQ(at, png.size());
    EXPECT_EQ(test::decode(png).width, 5);
}

TEST(Metadata, ExrHasAttributes) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    // Some keys are also names of attributes that OpenEXR defines with other types.
    const ImageMetadata metadata{
        {"seed", "7"}, {"version", "1.2.3"}, {"channels", "all"}, {"settings", "spp = 4\n"}};
    writeImage(path, gradient(5, 4), metadata);
    const Imf::InputFile file(path.c_str());
    for (const auto& [key, value] : metadata) {
        const auto* attribute = file.header().findTypedAttribute<Imf::StringAttribute>("rayscope:" + key);
        ASSERT_NE(attribute, nullptr) << key;
        EXPECT_EQ(attribute->value(), value);
    }
}

TEST(Metadata, TheSameImageAndMetadataGiveTheSameFile) {
    const RgbImage image = gradient(33, 21);
    const ImageMetadata metadata{{"seed", "7"}};
    EXPECT_EQ(image::encodeExr(image, metadata), image::encodeExr(image, metadata));
    EXPECT_EQ(image::encodePng(image, metadata, Encoding::Srgb),
              image::encodePng(image, metadata, Encoding::Srgb));
}

}  // namespace
}  // namespace rayscope
