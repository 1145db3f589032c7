#include "image/codecs/exr_file.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <bit>
#include <cstring>

namespace rayscope::image {

namespace {

static_assert(std::endian::native == std::endian::little, "EXR files are little-endian");

/// Flags of the version field.
constexpr std::uint32_t kTiled = 0x200, kDeep = 0x800, kMultiPart = 0x1000;

class Cursor {
  public:
    Cursor(FileBytes bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    std::size_t position() const { return position_; }
    std::size_t left() const { return bytes_.size() - position_; }

    template <class T>
    T number() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    FileBytes take(std::size_t count) {
        if (count > left()) throwDamaged(name_, "unexpected end of a header");
        position_ += count;
        return bytes_.subspan(position_ - count, count);
    }
    /// Text that ends with a zero byte.
    std::string text() {
        const auto* start = reinterpret_cast<const char*>(bytes_.data()) + position_;
        constexpr std::size_t kLongestName = 255;
        const std::size_t length = ::strnlen(start, std::min(left(), kLongestName + 1));
        if (length == left() || length > kLongestName) throwDamaged(name_, "a name in a header has no end");
        position_ += length + 1;
        return {start, length};
    }

  private:
    FileBytes bytes_;
    const std::string& name_;
    std::size_t position_ = 0;
};

std::string asText(FileBytes value) { return {reinterpret_cast<const char*>(value.data()), value.size()}; }

template <class T>
std::optional<T> asNumber(FileBytes value) {
    if (value.size() != sizeof(T)) return std::nullopt;
    T number;
    std::memcpy(&number, value.data(), sizeof number);
    return number;
}

std::vector<ExrChannel> readChannels(FileBytes value, const std::string& file) {
    std::vector<ExrChannel> channels;
    Cursor in(value, file);
    while (in.left() > 1) {
        ExrChannel channel;
        channel.name = in.text();
        channel.type = in.number<std::int32_t>();
        in.take(4);  // a hint for lossy compression, reserved bytes
        channel.xSampling = in.number<std::int32_t>();
        channel.ySampling = in.number<std::int32_t>();
        if (channel.type < 0 || channel.type > 2 || channel.xSampling < 1 || channel.ySampling < 1)
            throwDamaged(file, fmt::format("channel '{}' has an unknown type or sampling", channel.name));
        channels.push_back(std::move(channel));
    }
    return channels;
}

ExrTiles readTiles(FileBytes value, const std::string& file) {
    Cursor in(value, file);
    ExrTiles tiles;
    tiles.width = in.number<std::uint32_t>();
    tiles.height = in.number<std::uint32_t>();
    const auto mode = in.number<std::uint8_t>();
    tiles.levels = mode & 0xf;
    tiles.roundUp = mode >> 4 == 1;
    if (tiles.width == 0 || tiles.height == 0 || tiles.levels > 2)
        throwDamaged(file, fmt::format("tiles of {} x {} pixels", tiles.width, tiles.height));
    return tiles;
}

/// Throws if a thumbnail announces more pixels than it has.
void checkPreview(FileBytes value, const std::string& file) {
    Cursor in(value, file);
    const std::uint64_t width = in.number<std::uint32_t>(), height = in.number<std::uint32_t>();
    if (width * height != in.left() / 4)
        throwDamaged(file, fmt::format("a preview of {} x {} pixels in {} bytes", width, height, in.left()));
}

void readAttribute(ExrPart& part, const std::string& key, FileBytes value, const std::string& file) {
    if (key == "channels") part.channels = readChannels(value, file);
    if (key == "compression") part.compression = asNumber<std::uint8_t>(value).value_or(255);
    if (key == "dataWindow") part.dataWindow = asNumber<ExrBox>(value).value_or(ExrBox{});
    if (key == "displayWindow") part.displayWindow = asNumber<ExrBox>(value).value_or(ExrBox{});
    if (key == "tiles") part.tiles = readTiles(value, file);
    if (key == "preview") checkPreview(value, file);
    if (key == "name") part.name = asText(value);
    if (key == "type") part.type = asText(value);
    if (key == "chunkCount") part.blockCount = asNumber<std::int32_t>(value);
    if (key == "chromaticities") part.chromaticities = asNumber<std::array<float, 8>>(value);
    if (key == "pixelAspectRatio") part.pixelAspectRatio = asNumber<float>(value);
    if (key == "whiteLuminance") part.whiteLuminance = asNumber<float>(value);
}

ExrPart readHeader(Cursor& in, const std::string& file) {
    ExrPart part;
    for (std::string key = in.text(); !key.empty(); key = in.text()) {
        in.text();  // the type of the attribute
        const auto size = in.number<std::int32_t>();
        if (size < 0 || static_cast<std::size_t>(size) > in.left())
            throwDamaged(file, fmt::format("the attribute '{}' announces {} bytes, the file has {} more", key,
                                           size, in.left()));
        readAttribute(part, key, in.take(static_cast<std::size_t>(size)), file);
    }
    return part;
}

}  // namespace

ExrFile readExrHeaders(FileBytes file, const std::string& name) {
    Cursor in(file, name);
    in.number<std::uint32_t>();  // the signature
    const auto version = in.number<std::uint32_t>();
    if ((version & 0xff) != 2)
        throw InputError(fmt::format("EXR image of version {}; only version 2 is known", version & 0xff),
                         {name});
    ExrFile headers;
    headers.multiPart = (version & kMultiPart) != 0;
    do {
        ExrPart part = readHeader(in, name);
        part.isDeep = part.type.starts_with("deep") || (part.type.empty() && (version & kDeep) != 0);
        // Files of one part may lack the type, and their flag decides.
        const bool isTiled = headers.multiPart || part.isDeep
                                 ? part.type == "tiledimage" || part.type == "deeptile"
                                 : (version & kTiled) != 0;
        if (isTiled && !part.tiles) throwDamaged(name, "a tiled image without the size of its tiles");
        if (!isTiled) part.tiles.reset();
        headers.parts.push_back(std::move(part));
        // An empty header ends the headers of a file with several parts.
    } while (headers.multiPart && in.left() > 0 && file[in.position()] != std::byte{0});
    if (headers.multiPart) in.take(1);
    headers.headerSize = in.position();
    return headers;
}

}  // namespace rayscope::image
