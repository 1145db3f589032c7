#include "image/exr_files.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <cstring>

namespace rayscope::test {

namespace {

class MemoryStream : public Imf::OStream {
  public:
    MemoryStream() : OStream("memory") {}
    void write(const char data[], int size) override {
        const std::size_t count = static_cast<std::size_t>(size);
        if (bytes.size() < position_ + count) bytes.resize(position_ + count);
        std::memcpy(bytes.data() + position_, data, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::string bytes;

  private:
    std::size_t position_ = 0;
};

/// The samples of all channels, 4 bytes each, in the type of the file.
class Samples {
  public:
    Samples(const std::vector<std::string>& channels, Imf::PixelType type, const Imath::Box2i& window,
            const ExrPixels& pixels, float scale = 1.0f) {
        const int width = window.max.x - window.min.x + 1;
        for (const std::string& channel : channels) {
            std::vector<std::uint32_t>& memory = memory_.emplace_back();
            for (int y = window.min.y; y <= window.max.y; ++y)
                for (int x = window.min.x; x <= window.max.x; ++x)
                    memory.push_back(encode(scale * pixels(channel, x, y), type));
            const auto first = static_cast<std::intptr_t>(window.min.y) * width + window.min.x;
            char* origin =
                reinterpret_cast<char*>(reinterpret_cast<std::intptr_t>(memory.data()) - 4 * first);
            buffer.insert(channel, Imf::Slice(type, origin, 4, 4 * static_cast<std::size_t>(width)));
        }
    }
    Imf::FrameBuffer buffer;

  private:
    static std::uint32_t encode(float value, Imf::PixelType type) {
        if (type == Imf::UINT) return static_cast<std::uint32_t>(value);
        std::uint32_t bits = 0;
        const half small(value);
        if (type == Imf::HALF)
            std::memcpy(&bits, &small, 2);
        else
            std::memcpy(&bits, &value, 4);
        return bits;
    }
    std::vector<std::vector<std::uint32_t>> memory_;
};

Imf::Header withChannels(Imf::Header header, const std::vector<std::string>& channels, Imf::PixelType type) {
    for (const std::string& channel : channels) header.channels().insert(channel, Imf::Channel(type));
    return header;
}

}  // namespace

std::string ExrWriter::scanLines(const ExrPixels& pixels) {
    const Imath::Box2i window = header.dataWindow();
    Samples samples(channels, type, window, pixels, scale);
    MemoryStream stream;
    {
        Imf::OutputFile output(stream, withChannels(header, channels, type));
        output.setFrameBuffer(samples.buffer);
        output.writePixels(window.max.y - window.min.y + 1);
    }
    return stream.bytes;
}

std::string ExrWriter::tiles(const ExrPixels& pixels) {
    Samples samples(channels, type, header.dataWindow(), pixels, scale);
    MemoryStream stream;
    {
        Imf::TiledOutputFile output(stream, withChannels(header, channels, type));
        output.setFrameBuffer(samples.buffer);
        for (int ly = 0; ly < output.numYLevels(); ++ly)
            for (int lx = 0; lx < output.numXLevels(); ++lx)
                if (output.isValidLevel(lx, ly))
                    output.writeTiles(0, output.numXTiles(lx) - 1, 0, output.numYTiles(ly) - 1, lx, ly);
    }
    return stream.bytes;
}

std::string exrOfParts(const std::vector<std::vector<std::string>>& channels, int width, int height,
                       const ExrPixels& pixels) {
    std::vector<Imf::Header> headers;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        headers.push_back(withChannels(Imf::Header(width, height), channels[i], Imf::HALF));
        headers.back().setName("part" + std::to_string(i));
        headers.back().setType(Imf::SCANLINEIMAGE);
    }
    MemoryStream stream;
    {
        Imf::MultiPartOutputFile output(stream, headers.data(), static_cast<int>(headers.size()));
        for (std::size_t i = 0; i < channels.size(); ++i) {
            Samples samples(channels[i], Imf::HALF, headers[i].dataWindow(), pixels);
            Imf::OutputPart part(output, static_cast<int>(i));
            part.setFrameBuffer(samples.buffer);
            part.writePixels(height);
        }
    }
    return stream.bytes;
}

std::string deepExr(int width, int height) {
    const auto count = static_cast<std::size_t>(width * height);
    Imf::Header header = withChannels(Imf::Header(width, height), {"R"}, Imf::FLOAT);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    std::vector<unsigned> counts(count, 1);
    std::vector<float> values(count, 0.5f);
    std::vector<float*> pointers;
    for (float& value : values) pointers.push_back(&value);
    Imf::DeepFrameBuffer buffer;
    const std::size_t row = static_cast<std::size_t>(width);
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                             sizeof(unsigned), sizeof(unsigned) * row));
    buffer.insert("R", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                      sizeof(float*) * row, sizeof(float)));
    MemoryStream stream;
    {
        Imf::DeepScanLineOutputFile output(stream, header);
        output.setFrameBuffer(buffer);
        output.writePixels(height);
    }
    return stream.bytes;
}

}  // namespace rayscope::test
