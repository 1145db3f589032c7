#pragma once
// The headers and blocks of an EXR file, checked against its size before OpenEXR allocates or decodes
// anything: the library trusts them, and leaves memory of blocks that hold too little uninitialised.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "image/codecs/codecs.h"

namespace rayscope::image {

/// A rectangle of pixels; both ends are included.
struct ExrBox {
    std::int32_t left = 0, top = 0, right = -1, bottom = -1;
    long long width() const { return static_cast<long long>(right) - left + 1; }
    long long height() const { return static_cast<long long>(bottom) - top + 1; }
    bool operator==(const ExrBox&) const = default;
};

struct ExrChannel {
    std::string name;
    std::int32_t type = 0;  ///< 0 UINT, 1 HALF, 2 FLOAT
    std::int32_t xSampling = 1, ySampling = 1;
};

struct ExrTiles {
    std::uint32_t width = 0, height = 0;
    int levels = 0;  ///< 0: one, 1: mipmap, 2: ripmap
    bool roundUp = false;
};

/// The samples that a channel has in a box.
struct ExrSamples {
    long long columns, rows;
};
ExrSamples samplesOf(const ExrChannel& channel, const ExrBox& box);
/// Bytes of an uncompressed sample.
long long sampleSize(const ExrChannel& channel);

/// One image of the file.
struct ExrPart {
    std::string name, type;
    std::vector<ExrChannel> channels;
    int compression = -1;
    ExrBox dataWindow, displayWindow;
    std::optional<ExrTiles> tiles;
    std::optional<std::int32_t> blockCount;              ///< as announced; in files of several parts
    std::optional<std::array<float, 8>> chromaticities;  ///< x and y of red, green, blue and white
    std::optional<float> pixelAspectRatio, whiteLuminance;
    bool isDeep = false;
};

struct ExrFile {
    bool multiPart = false;
    std::vector<ExrPart> parts;
    std::size_t headerSize = 0;  ///< bytes before the tables of block offsets
};

/// Reads the headers. Throws InputError if they are damaged or announce more than the file can hold.
ExrFile readExrHeaders(FileBytes file, const std::string& name);

/// Throws InputError unless each block of a part is in the file and holds all of its pixels.
void checkExrBlocks(FileBytes file, const ExrFile& headers, std::size_t part, const std::string& name);

/// Whether the streams of a block with DWA compression have the sizes that its channels need in a box.
bool fillsWithDwa(FileBytes packed, const ExrPart& part, const ExrBox& box);

}  // namespace rayscope::image
