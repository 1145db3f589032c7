// exr_seeds FOLDER: writes small EXR files of every kind and compression with OpenEXR, for the fuzzer.
#include <ImfTileDescriptionAttribute.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "image/exr_files.h"

namespace {

using rayscope::test::ExrWriter;

constexpr int kWidth = 9, kHeight = 6;

float pixelAt(const std::string& channel, int x, int y) {
    return 0.125f * static_cast<float>(x + kWidth * y) + static_cast<float>(channel.size());
}

struct Compression {
    const char* name;
    Imf::Compression value;
};
constexpr Compression kCompressions[]{
    {"none", Imf::NO_COMPRESSION},   {"rle", Imf::RLE_COMPRESSION},   {"zips", Imf::ZIPS_COMPRESSION},
    {"zip", Imf::ZIP_COMPRESSION},   {"piz", Imf::PIZ_COMPRESSION},   {"pxr24", Imf::PXR24_COMPRESSION},
    {"b44", Imf::B44_COMPRESSION},   {"b44a", Imf::B44A_COMPRESSION}, {"dwaa", Imf::DWAA_COMPRESSION},
    {"dwab", Imf::DWAB_COMPRESSION},
};

}  // namespace

int main(int count, char** arguments) {
    const std::span all(arguments, static_cast<std::size_t>(count));
    if (all.size() != 2) return 1;
    const std::filesystem::path folder = all[1];
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& file) {
        std::ofstream(folder / name, std::ios::binary) << file;
    };
    for (const Compression& compression : kCompressions)
        for (const auto& [suffix, type] :
             {std::pair{"half", Imf::HALF}, {"float", Imf::FLOAT}, {"uint", Imf::UINT}}) {
            ExrWriter writer(kWidth, kHeight);
            writer.header.compression() = compression.value;
            writer.type = type;
            write(std::string(compression.name) + "-" + suffix, writer.scanLines(pixelAt));
            writer.header.setTileDescription({4, 4, Imf::MIPMAP_LEVELS});
            write(std::string(compression.name) + "-" + suffix + "-tiles", writer.tiles(pixelAt));
        }
    ExrWriter window(Imath::Box2i({0, 0}, {kWidth - 1, kHeight - 1}), Imath::Box2i({-2, 1}, {5, 4}));
    write("window", window.scanLines(pixelAt));
    ExrWriter luminance(kWidth, kHeight);
    luminance.channels = {"Y", "A"};
    write("luminance", luminance.scanLines(pixelAt));
    write("parts", rayscope::test::exrOfParts({{"Z"}, {"R", "G", "B"}}, kWidth, kHeight, pixelAt));
    write("deep", rayscope::test::deepExr(kWidth, kHeight));
    return 0;
}
