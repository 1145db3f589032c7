// What EXR files hold, written with OpenEXR: types, compression, tiles, layers, parts, windows, colours.
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTileDescriptionAttribute.h>
#include <gmock/gmock.h>
#include <half.h>

#include <cstring>

#include "image/exr_files.h"
#include "image/test_images.h"
#include "support/expect_input_error.h"
#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using test::ExrWriter;
using test::inputErrorOf;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RgbImage decodedExr(const std::string& file, std::vector<std::string>* notes = nullptr) {
    Diagnostics found;
    RgbImage image = image::decodeExr(std::as_bytes(std::span(file)), "x.exr", &found);
    if (notes)
        for (const Diagnostic& note : found) notes->push_back(note.message);
    return image;
}
std::vector<std::string> exrNotes(const std::string& file) {
    std::vector<std::string> notes;
    decodedExr(file, &notes);
    return notes;
}
std::string exrError(const std::string& file) {
    return inputErrorOf([&] { decodedExr(file); });
}

/// The value of a channel at a pixel; exact in half and, times 1000, as an integer.
float valueAt(const std::string& channel, int x, int y) {
    const char last = channel.back();
    const float base = last == 'R' || last == 'r' ? 1.0f : last == 'G' || last == 'g' ? 2.0f : 3.0f;
    return base + static_cast<float>(x) / 16.0f + static_cast<float>(y) / 256.0f;
}

void expectPixels(const RgbImage& image, int left, int top, float tolerance = 0.0f, float scale = 1.0f) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Rgb expected = scale * Rgb(valueAt("R", x + left, y + top), valueAt("G", x + left, y + top),
                                             valueAt("B", x + left, y + top));
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.at(x, y)[c], expected[c], tolerance) << x << ' ' << y;
        }
}

TEST(Exr, EveryCompressionTypeAndLineOrderIsRead) {
    for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression)
        for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT})
            for (const Imf::LineOrder order : {Imf::INCREASING_Y, Imf::DECREASING_Y}) {
                ExrWriter writer(37, 300);
                writer.header.compression() = static_cast<Imf::Compression>(compression);
                writer.header.lineOrder() = order;
                writer.type = type;
                if (type == Imf::UINT) writer.scale = 1024.0f;
                std::vector<std::string> notes;
                const RgbImage image = decodedExr(writer.scanLines(valueAt), &notes);
                ASSERT_EQ(image.width, 37);
                ASSERT_EQ(image.height, 300);
                // B44 and DWA are lossy for half, PXR24 for float.
                const bool lossy = compression >= Imf::PXR24_COMPRESSION;
                expectPixels(image, 0, 0, (lossy ? 0.02f : 0.0f) * writer.scale, writer.scale);
                EXPECT_THAT(notes, IsEmpty());
            }
}

TEST(Exr, TilesAndTheFirstLevelOfMipmapsAreRead) {
    for (const Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS})
        for (const Imf::LevelRoundingMode rounding : {Imf::ROUND_DOWN, Imf::ROUND_UP})
            for (const auto& [width, height] : {std::pair{37, 21}, std::pair{16, 16}, std::pair{1, 5}}) {
                ExrWriter writer(width, height);
                writer.header.setTileDescription({16, 8, mode, rounding});
                writer.header.compression() = Imf::ZIP_COMPRESSION;
                const RgbImage image = decodedExr(writer.tiles(valueAt));
                ASSERT_EQ(image.width, width);
                expectPixels(image, 0, 0);
            }
}

TEST(Exr, TheDisplayWindowIsThePicture) {
    // Inside, around, beside and beyond the display window of 16 x 12 at (-2, 3).
    const Imath::Box2i display({-2, 3}, {13, 14});
    for (const Imath::Box2i& data : {Imath::Box2i({4, 4}, {11, 11}), Imath::Box2i({-7, -9}, {30, 31}),
                                     Imath::Box2i({-5, 8}, {4, 40}), Imath::Box2i({100, 100}, {107, 107})}) {
        ExrWriter writer(display, data);
        std::vector<std::string> notes;
        const RgbImage image = decodedExr(writer.scanLines(valueAt), &notes);
        ASSERT_EQ(image.width, 16);
        ASSERT_EQ(image.height, 12);
        EXPECT_THAT(notes, ElementsAre(HasSubstr("black where it has no data")));
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 16; ++x) {
                const int px = x + display.min.x, py = y + display.min.y;
                const bool inside =
                    px >= data.min.x && px <= data.max.x && py >= data.min.y && py <= data.max.y;
                EXPECT_EQ(image.at(x, y).x, inside ? valueAt("R", px, py) : 0.0f) << x << ' ' << y;
            }
    }
    // The same window away from the origin needs no note.
    ExrWriter moved(display, display);
    EXPECT_THAT(exrNotes(moved.scanLines(valueAt)), IsEmpty());
    expectPixels(decodedExr(moved.scanLines(valueAt)), display.min.x, display.min.y);
}

RgbImage imageOf(const std::vector<std::string>& channels, std::vector<std::string>* notes = nullptr) {
    ExrWriter writer(4, 3);
    writer.channels = channels;
    return decodedExr(writer.scanLines(valueAt), notes);
}

TEST(Exr, ChannelsAndLayersAreChosenByName) {
    std::vector<std::string> notes;
    expectPixels(imageOf({"R", "G", "B", "A", "Z", "diffuse.R", "N.X", "N.Y", "N.Z"}, &notes), 0, 0);
    EXPECT_THAT(notes, IsEmpty());

    const RgbImage red = imageOf({"R", "A"}, &notes);
    EXPECT_EQ(red.at(1, 2), Rgb(valueAt("R", 1, 2), 0.0f, 0.0f));
    EXPECT_THAT(notes, ElementsAre(HasSubstr("no channel G and B")));
    notes.clear();

    expectPixels(
        imageOf({"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Depth.Z",
                 "ViewLayer.Normal.X", "ViewLayer.Normal.Y", "ViewLayer.Normal.Z"},
                &notes),
        0, 0);
    EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("'ViewLayer.Combined'"), HasSubstr("2 others"))));
    notes.clear();

    expectPixels(imageOf({"r", "g", "b"}, &notes), 0, 0);
    EXPECT_THAT(notes, IsEmpty());

    const RgbImage grey = imageOf({"Y", "A", "diffuse.R"}, &notes);
    EXPECT_EQ(grey.at(1, 2), Rgb(valueAt("Y", 1, 2)));
    EXPECT_THAT(notes, IsEmpty());
}

TEST(Exr, WithoutAPictureTheChannelsAreListed) {
    for (const std::vector<std::string>& channels :
         {std::vector<std::string>{"Z"}, {"X", "Y", "Z"}, {"P.X", "P.Y", "P.Z"}, {"U", "V"}})
        EXPECT_THAT(inputErrorOf([&] { imageOf(channels); }),
                    AllOf(HasSubstr("x.exr"), HasSubstr("without channels R, G, B or Y"),
                          HasSubstr("it has " + channels.front())));
    std::vector<std::string> many;
    for (int i = 0; i < 40; ++i) many.push_back("c" + std::to_string(i));
    EXPECT_THAT(inputErrorOf([&] { imageOf(many); }), HasSubstr("and 28 more"));
}

TEST(Exr, TheFirstPartWithAPictureIsRead) {
    std::vector<std::string> notes;
    const std::string file = test::exrOfParts({{"Z"}, {"R", "G", "B"}, {"R"}}, 8, 5, valueAt);
    expectPixels(decodedExr(file, &notes), 0, 0);
    EXPECT_THAT(notes, ElementsAre(AllOf(HasSubstr("part 2 of 3"), HasSubstr("part1"))));
    EXPECT_THAT(exrError(test::exrOfParts({{"Z"}, {"W"}}, 8, 5, valueAt)), HasSubstr("it has Z, W"));
}

TEST(Exr, DeepImagesAreRefusedByName) {
    EXPECT_THAT(exrError(test::deepExr(4, 4)), AllOf(HasSubstr("deep"), HasSubstr("flatten")));
}

TEST(Exr, LuminanceAndChromaAreReadLikeTheLibraryReadsThem) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("yc.exr");
    constexpr int kSize = 32;
    std::vector<Imf::Rgba> pixels(kSize * kSize);
    for (int i = 0; i < kSize * kSize; ++i)
        pixels[static_cast<std::size_t>(i)] = {half(static_cast<float>(i % kSize) / kSize), half(0.25f),
                                               half(static_cast<float>(i / kSize) / kSize), half(1.0f)};
    for (const Imf::RgbaChannels channels : {Imf::WRITE_YC, Imf::WRITE_YCA, Imf::WRITE_Y}) {
        {
            Imf::RgbaOutputFile output(path.c_str(), kSize, kSize, channels);
            output.setFrameBuffer(pixels.data(), 1, kSize);
            output.writePixels(kSize);
        }
        Imf::RgbaInputFile oracle(path.c_str());
        std::vector<Imf::Rgba> expected(pixels.size());
        oracle.setFrameBuffer(expected.data(), 1, kSize);
        oracle.readPixels(0, kSize - 1);
        const RgbImage image = readImage(path);
        ASSERT_EQ(image.pixels.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ(image.pixels[i].x, float{expected[i].r}) << i;
            EXPECT_EQ(image.pixels[i].y, float{expected[i].g}) << i;
            EXPECT_EQ(image.pixels[i].z, float{expected[i].b}) << i;
        }
        if (channels == Imf::WRITE_Y) continue;
        EXPECT_NEAR(image.at(28, 4).x, 28.0f / kSize, 0.05f);  // coloured, not grey
    }
}

TEST(Exr, OtherPrimariesAreConverted) {
    ExrWriter writer(2, 1);
    writer.type = Imf::FLOAT;
    Imf::addChromaticities(writer.header,
                           {{0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}});
    std::vector<std::string> notes;
    const std::string file =
        writer.scanLines([](const std::string& c, int x, int) { return x == 0 || c == "R" ? 1.0f : 0.0f; });
    const RgbImage image = decodedExr(file, &notes);
    EXPECT_THAT(notes, ElementsAre(HasSubstr("other primaries than sRGB")));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(0, 0)[c], 1.0f, 1e-6f);  // white stays white
    // ITU-R BT.2087, table 4.
    EXPECT_NEAR(image.at(1, 0).x, 1.6605f, 1e-4f);
    EXPECT_NEAR(image.at(1, 0).y, -0.1246f, 1e-4f);
    EXPECT_NEAR(image.at(1, 0).z, -0.0182f, 1e-4f);

    // Another white (ACES, D60) stays white too; degenerate primaries are ignored.
    Imf::addChromaticities(writer.header,
                           {{0.7347f, 0.2653f}, {0.0f, 1.0f}, {0.0001f, -0.077f}, {0.32168f, 0.33767f}});
    const RgbImage white = decodedExr(writer.scanLines([](const std::string&, int, int) { return 1.0f; }));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(white.at(0, 0)[c], 1.0f, 1e-6f);
    Imf::addChromaticities(writer.header, {{0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}});
    EXPECT_THAT(exrNotes(writer.scanLines(valueAt)), ElementsAre(HasSubstr("no triangle")));
    Imf::addChromaticities(writer.header, Imf::Chromaticities());  // those of sRGB
    EXPECT_THAT(exrNotes(writer.scanLines(valueAt)), IsEmpty());
}

TEST(Exr, PixelAspectAndWhiteAreNoted) {
    ExrWriter writer(4, 4);
    writer.header.pixelAspectRatio() = 2.0f;
    Imf::addWhiteLuminance(writer.header, 120.0f);
    EXPECT_THAT(exrNotes(writer.scanLines(valueAt)),
                ElementsAre(HasSubstr("aspect ratio of 2"), HasSubstr("120 cd/m²")));
}

}  // namespace
}  // namespace rayscope
