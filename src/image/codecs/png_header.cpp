#include "image/codecs/png_header.h"

#include <fmt/format.h>

#include <string_view>

#include "image/codecs/byte_cursor.h"
#include "image/codecs/embedded_metadata.h"

namespace rayscope::image {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n"sv;
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum

struct Chunk {
    std::string_view type;
    FileBytes data;  ///< shorter than announced if the file ends
    std::size_t end;
};

Chunk chunkAt(FileBytes bytes, std::size_t at) {
    const std::size_t length = bigEndian32(bytes, at);
    const FileBytes rest = bytes.subspan(at + 8);
    return {textOf(bytes.subspan(at + 4, 4)), rest.first(std::min(length, rest.size())),
            at + kChunkFrame + length};
}

void checkSize(const ImageFile& file, FileBytes header) {
    const long long width = bigEndian32(header, 0), height = bigEndian32(header, 4);
    checkImageSize(width, height, file.bytes.size(), file.name);
    constexpr int kSamplesOfColorType[]{1, 0, 3, 1, 2, 0, 4};
    const std::uint32_t depth = byteAt(header, 8), colorType = byteAt(header, 9);
    const int samples = colorType < 7 ? kSamplesOfColorType[colorType] : 0;
    constexpr long long kMaxDeflateRatio = 1032;
    if (width * height / 8 * depth * samples / kMaxDeflateRatio > static_cast<long long>(file.bytes.size()))
        file.damaged(fmt::format("{} x {} pixels in a file of {} bytes", width, height, file.bytes.size()));
}

void report(const ImageFile& file, const Chunk& chunk) {
    if (chunk.type == "acTL") file.note("an animation: only its first image is read");
    if (chunk.type == "eXIf") noteExifOrientation(file, chunk.data);
    constexpr std::string_view kSrgbCodes = "\1\x0d\0\1"sv;
    if (chunk.type == "cICP" && textOf(chunk.data) != kSrgbCodes)
        file.warn("the colour space of the image (cICP) is ignored: the colours are read as sRGB");
}

}  // namespace

void checkPngHeader(const ImageFile& file) {
    const std::string_view text = textOf(file.bytes);
    if (!text.starts_with(kSignature.substr(0, text.size())))
        file.damaged("its signature is changed, as by a transfer in text mode");
    constexpr std::size_t kHeaderLength = 13;
    const std::size_t first = kSignature.size();
    if (text.size() < first + kChunkFrame + kHeaderLength) file.damaged(kEndsTooEarly);
    if (text.substr(first + 4, 4) == "CgBI")
        file.refuse(
            "is a PNG in the format of iOS applications (CgBI); convert it with 'pngcrush "
            "-revert-iphone-optimizations'");
    if (text.substr(first + 4, 4) != "IHDR") file.damaged("the header chunk IHDR is missing");
    checkSize(file, file.bytes.subspan(first + 8, kHeaderLength));
    for (std::size_t at = first; at + kChunkFrame <= file.bytes.size();) {
        const Chunk chunk = chunkAt(file.bytes, at);
        if (chunk.type == "IDAT" || chunk.type == "IEND") break;
        report(file, chunk);
        at = chunk.end;
    }
}

}  // namespace rayscope::image
