#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stop_token>

#include "base/memory_budget.h"
#include "image/codecs/codecs.h"

namespace rayscope::image {

namespace {

class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : OStream("memory") {}

    void write(const char data[], int size) override {
        const std::size_t end = position_ + static_cast<std::size_t>(size);
        if (bytes.size() < end) bytes.resize(end);
        std::memcpy(bytes.data() + position_, data, static_cast<std::size_t>(size));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = static_cast<std::size_t>(position); }

    std::string bytes;

  private:
    std::size_t position_ = 0;
};

constexpr std::array<const char*, 3> kColour{"R", "G", "B"};
/// The memory layout of the pixels for OpenEXR, which takes char* but only reads.
Imf::FrameBuffer describeMemory(const RgbImage& image) {
    char* first = const_cast<char*>(reinterpret_cast<const char*>(image.pixels.data()));
    const std::size_t rowSize = sizeof(Rgb) * static_cast<std::size_t>(image.width);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < kColour.size(); ++i)
        buffer.insert(kColour[i], Imf::Slice(Imf::FLOAT, first + i * sizeof(float), sizeof(Rgb), rowSize));
    return buffer;
}

/// Empty if a stop is requested before the last rows.
std::string encode(const RgbImage& image, const ImageMetadata& metadata, Imf::Compression compression,
                   const std::stop_token& stop) {
    Imf::Header header(image.width, image.height);
    header.compression() = compression;
    for (const char* channel : kColour) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    for (const auto& [key, value] : metadata) header.insert(metadataName(key), Imf::StringAttribute(value));

    MemoryOutput stream;
    const std::size_t pixelBytes = image.pixels.size() * sizeof(Rgb);
    if (compression == Imf::NO_COMPRESSION) stream.bytes.reserve(pixelBytes + pixelBytes / 64);
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(describeMemory(image));
        constexpr int kRows = 16;  // which ZIP compresses together
        for (int y = 0; y < image.height; y += kRows) {
            if (stop.stop_requested()) return {};
            output.writePixels(std::min(kRows, image.height - y));
        }
    }  // the destructor of `output` writes the table of line offsets
    return std::move(stream.bytes);
}

}  // namespace

std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata,
                      const std::stop_token& compressing) try {
    std::string file = encode(image, metadata, Imf::ZIP_COMPRESSION, compressing);
    return file.empty() ? encode(image, metadata, Imf::NO_COMPRESSION, {}) : file;
} catch (const std::exception& error) {
    if (base::reportsLackOfMemory(error)) throw std::bad_alloc();
    throw;
}

}  // namespace rayscope::image
