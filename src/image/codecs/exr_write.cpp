#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <array>
#include <cstdint>
#include <cstring>

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

}  // namespace

std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata) try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : kColour) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    for (const auto& [key, value] : metadata) header.insert(metadataName(key), Imf::StringAttribute(value));

    MemoryOutput stream;
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(describeMemory(image));
        output.writePixels(image.height);
    }  // the destructor of `output` writes the table of line offsets
    return std::move(stream.bytes);
} catch (const std::exception& error) {
    if (base::reportsLackOfMemory(error)) throw std::bad_alloc();
    throw;
}

}  // namespace rayscope::image
