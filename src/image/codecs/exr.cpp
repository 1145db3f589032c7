#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <rayscope/diagnostics.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "image/codecs/codecs.h"

namespace rayscope::image {

namespace {

class MemoryInput : public Imf::IStream {
  public:
    MemoryInput(FileBytes file, const std::string& name) : IStream(name.c_str()), file_(file) {}

    bool read(char data[], int size) override {
        const std::size_t count = static_cast<std::size_t>(size);
        if (position_ > file_.size() || count > file_.size() - position_)
            throw std::runtime_error("unexpected end of file");
        std::memcpy(data, file_.data() + position_, count);
        position_ += count;
        return position_ < file_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = static_cast<std::size_t>(position); }

  private:
    FileBytes file_;
    std::size_t position_ = 0;
};

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

using ChannelNames = std::array<const char*, 3>;
constexpr ChannelNames kColour{"R", "G", "B"};
constexpr ChannelNames kLuminance{"Y", "Y", "Y"};

/// The memory layout of the pixels for OpenEXR. A slice starts at pixel (0, 0) of the data window's
/// coordinates, which lies outside the allocation unless the first pixel (`left`, `top`) is (0, 0); hence
/// integer arithmetic instead of pointer arithmetic.
Imf::FrameBuffer describeMemory(const RgbImage& image, int left, int top, const ChannelNames& names) {
    const std::intptr_t first = static_cast<std::intptr_t>(top) * image.width + left;
    const std::intptr_t pixelSize = sizeof(Rgb);
    const std::intptr_t origin = reinterpret_cast<std::intptr_t>(image.pixels.data()) - first * pixelSize;
    const std::size_t rowSize = sizeof(Rgb) * static_cast<std::size_t>(image.width);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < names.size(); ++i) {
        char* base = reinterpret_cast<char*>(origin + static_cast<std::intptr_t>(i * sizeof(float)));
        buffer.insert(names[i], Imf::Slice(Imf::FLOAT, base, sizeof(Rgb), rowSize));
    }
    return buffer;
}

struct Window {
    int left, top, width, height;
};

/// The data window. Throws InputError if its size is invalid, see checkImageSize().
Window checkedWindow(const Imf::Header& header, std::size_t fileSize, const std::string& name) {
    const auto& window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    checkImageSize(width, height, fileSize, name);
    return {window.min.x, window.min.y, static_cast<int>(width), static_cast<int>(height)};
}

/// Reads the header only: Imf::InputFile also allocates a table for all lines that the header announces.
Imf::Header readHeader(FileBytes file, const std::string& name) {
    constexpr std::uint64_t kAfterMagicAndVersion = 8;
    MemoryInput stream(file, name);
    stream.seekg(kAfterMagicAndVersion);
    int version = 2;  // the only version of the file format
    Imf::Header header;
    header.readFrom(stream, version);
    return header;
}

RgbImage readPixels(Imf::InputFile& input, std::size_t fileSize, const std::string& name) {
    const Window window = checkedWindow(input.header(), fileSize, name);
    const Imf::ChannelList& channels = input.header().channels();
    const bool coloured = channels.findChannel("R") || channels.findChannel("G") || channels.findChannel("B");
    if (!coloured && !channels.findChannel("Y"))
        throw InputError("EXR image without channels R, G, B or Y; export it with one of these", {name});

    RgbImage image(window.width, window.height);
    input.setFrameBuffer(describeMemory(image, window.left, window.top, coloured ? kColour : kLuminance));
    input.readPixels(window.top, window.top + window.height - 1);
    if (!coloured)
        for (Rgb& pixel : image.pixels) pixel = Rgb(pixel.z);
    return image;
}

}  // namespace

RgbImage decodeExr(FileBytes file, const std::string& name, Diagnostics*) try {
    checkedWindow(readHeader(file, name), file.size(), name);
    MemoryInput stream(file, name);
    Imf::InputFile input(stream);
    return readPixels(input, file.size(), name);
} catch (const InputError&) {
    throw;
} catch (const std::exception& error) {
    throwDamaged(name, error.what());
}

std::string encodeExr(const RgbImage& image, const ImageMetadata& metadata) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : kColour) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    for (const auto& [key, value] : metadata) header.insert(metadataName(key), Imf::StringAttribute(value));

    MemoryOutput stream;
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(describeMemory(image, 0, 0, kColour));
        output.writePixels(image.height);
    }  // the destructor of `output` writes the table of line offsets
    return std::move(stream.bytes);
}

}  // namespace rayscope::image
