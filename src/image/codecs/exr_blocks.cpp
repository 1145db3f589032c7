// The blocks of an EXR file: scan lines or tiles, compressed one by one.
#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "image/codecs/exr_file.h"

namespace rayscope::image {

namespace {

enum Compression { kNone = 0, kRle = 1, kZips = 2, kZip = 3, kDwaa = 8, kDwab = 9, kCompressions = 10 };
/// Scan lines per block of each compression method.
constexpr std::array<int, kCompressions> kLines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

/// The number of multiples of `step` from `first` to `last`.
long long multiples(long long first, long long last, long long step) {
    const auto floorOf = [step](long long x) { return x >= 0 ? x / step : -((-x + step - 1) / step); };
    return floorOf(last) - floorOf(first - 1);
}

/// Size of the uncompressed pixels of a box.
long long sizeOf(const ExrPart& part, const ExrBox& box) {
    long long size = 0;
    for (const ExrChannel& channel : part.channels) {
        const ExrSamples samples = samplesOf(channel, box);
        size += samples.columns * samples.rows * sampleSize(channel);
    }
    return size;
}

/// Number of tiles or blocks of `step` in `size`.
long long blocksIn(long long size, long long step) { return (size + step - 1) / step; }

/// The sizes of an image's axis on all levels.
std::vector<long long> levelSizes(long long size, long long longest, const ExrTiles& tiles) {
    std::vector<long long> sizes{size};
    for (long long l = 1, divisor = 2; tiles.levels != 0; ++l, divisor *= 2) {
        if (tiles.roundUp ? divisor >= 2 * longest : divisor > longest) break;
        sizes.push_back(std::max(1LL, tiles.roundUp ? blocksIn(size, divisor) : size / divisor));
    }
    return sizes;
}

/// The number of blocks of a part on all levels.
long long blockCount(const ExrPart& part) {
    const long long width = part.dataWindow.width(), height = part.dataWindow.height();
    if (!part.tiles) return blocksIn(height, kLines[static_cast<std::size_t>(part.compression)]);
    const ExrTiles& tiles = *part.tiles;
    const bool rip = tiles.levels == 2;
    const auto columns = levelSizes(width, rip ? width : std::max(width, height), tiles);
    const auto rows = levelSizes(height, rip ? height : std::max(width, height), tiles);
    long long count = 0;
    for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = rip ? 0 : y; x < (rip ? columns.size() : y + 1); ++x)
            count += blocksIn(columns[x], tiles.width) * blocksIn(rows[y], tiles.height);
    return count;
}

/// Whether run-length encoded data unpacks to `size` bytes.
bool fillsWithRuns(FileBytes packed, long long size) {
    std::size_t at = 0;
    while (at < packed.size()) {
        const int byte = std::to_integer<int>(packed[at]), code = byte < 128 ? byte : byte - 256;
        const int count = code < 0 ? -code : code + 1;
        at += code < 0 ? static_cast<std::size_t>(count) + 1 : 2;
        size -= count;
    }
    return at == packed.size() && size == 0;
}

class BlockChecker {
  public:
    BlockChecker(FileBytes file, const ExrFile& headers, std::size_t part, const std::string& name)
        : file_(file), headers_(headers), number_(part), part_(headers.parts[part]), name_(name) {}

    void run() {
        checkLayout();
        std::size_t table = headers_.headerSize;
        for (std::size_t i = 0; i < number_; ++i)
            table += 8 * static_cast<std::size_t>(blockCount(headers_.parts[i]));
        const long long count = blockCount(part_), first = firstLevelCount();
        for (long long i = 0; i < count; ++i) {
            const std::uint64_t offset = numberAt<std::uint64_t>(table + 8 * static_cast<std::size_t>(i));
            if (offset == 0)
                throwDamaged(name_, "its table of blocks is incomplete: writing it was interrupted");
            if (offset >= file_.size()) throwDamaged(name_, "a block lies behind the end of the file");
            if (i < first) checkBlock(boxOf(i), i, static_cast<std::size_t>(offset));
        }
    }

  private:
    /// Throws if the library would allocate far more than the file can fill.
    void checkLayout() const {
        std::size_t tables = headers_.headerSize;
        for (const ExrPart& part : headers_.parts) {
            if (part.compression < 0 || part.compression >= kCompressions)
                throw InputError(fmt::format("EXR image with the unknown compression method {}; save it with "
                                             "ZIP compression",
                                             part.compression),
                                 {name_});
            checkImageSize(part.dataWindow.width(), part.dataWindow.height(), file_.size(), name_);
            const long long count = blockCount(part);
            if (part.blockCount && *part.blockCount != count)
                throwDamaged(name_, fmt::format("{} blocks are announced, its size needs {}",
                                                *part.blockCount, count));
            tables += 8 * static_cast<std::size_t>(count);
            if (tables > file_.size()) throwDamaged(name_, "the file is shorter than its table of blocks");
        }
        constexpr long long kMaxBlockSize = 1LL << 30;
        ExrBox largest = part_.dataWindow;
        if (part_.tiles) {
            const long long area = static_cast<long long>(part_.tiles->width) * part_.tiles->height;
            const long long pixels = largest.width() * largest.height();
            if (area > std::max(1LL << 22, 16 * pixels) || part_.tiles->width > 1u << 24 ||
                part_.tiles->height > 1u << 24)
                throwDamaged(name_,
                             fmt::format("tiles of {} x {} pixels", part_.tiles->width, part_.tiles->height));
            largest = {0, 0, static_cast<std::int32_t>(part_.tiles->width) - 1,
                       static_cast<std::int32_t>(part_.tiles->height) - 1};
        } else {
            const int lines = kLines[static_cast<std::size_t>(part_.compression)];
            largest = {0, 0, static_cast<std::int32_t>(largest.width()) - 1, lines - 1};
        }
        if (sizeOf(part_, largest) > kMaxBlockSize)
            throw InputError(fmt::format("EXR image with {} channels: blocks of more than 2^30 bytes; save "
                                         "only the channels R, G and B",
                                         part_.channels.size()),
                             {name_});
    }

    long long tileColumns() const { return blocksIn(part_.dataWindow.width(), part_.tiles->width); }
    long long firstLevelCount() const {
        return part_.tiles ? tileColumns() * blocksIn(part_.dataWindow.height(), part_.tiles->height)
                           : blockCount(part_);
    }

    /// The pixels of a block of the first level.
    ExrBox boxOf(long long i) const {
        const ExrBox& window = part_.dataWindow;
        const long long width = part_.tiles ? part_.tiles->width : window.width();
        const long long height =
            part_.tiles ? part_.tiles->height : kLines[static_cast<std::size_t>(part_.compression)];
        const long long columns = part_.tiles ? tileColumns() : 1;
        const long long left = window.left + i % columns * width, top = window.top + i / columns * height;
        return {static_cast<std::int32_t>(left), static_cast<std::int32_t>(top),
                static_cast<std::int32_t>(std::min<long long>(left + width - 1, window.right)),
                static_cast<std::int32_t>(std::min<long long>(top + height - 1, window.bottom))};
    }

    void checkBlock(const ExrBox& box, long long i, std::size_t offset) {
        std::vector<std::int32_t> position{box.top};
        if (part_.tiles)
            position = {static_cast<std::int32_t>(i % tileColumns()),
                        static_cast<std::int32_t>(i / tileColumns()), 0, 0};
        if (headers_.multiPart) position.insert(position.begin(), static_cast<std::int32_t>(number_));
        const std::string where = fmt::format("the block at pixel {}, {}", box.left, box.top);
        for (const std::int32_t expected : position) {
            if (numberAt<std::int32_t>(offset) != expected)
                throwDamaged(name_, where + " is not where it should be");
            offset += sizeof expected;
        }
        const auto packedSize = numberAt<std::int32_t>(offset);
        offset += sizeof packedSize;
        if (packedSize < 0 || static_cast<std::size_t>(packedSize) > file_.size() - offset)
            throwDamaged(name_, where + " is cut off");
        const long long size = sizeOf(part_, box);
        if (!isFilled(file_.subspan(offset, static_cast<std::size_t>(packedSize)), box, size))
            throwDamaged(name_, fmt::format("{} does not hold {} bytes", where, size));
    }

    /// Whether packed pixels unpack to `size` bytes. Other methods are checked by the library.
    bool isFilled(FileBytes packed, const ExrBox& box, long long size) {
        const auto packedSize = static_cast<long long>(packed.size());
        if (packedSize >= size) return packedSize == size;
        if (packed.empty() || part_.compression == kNone) return false;
        if (part_.compression == kRle) return fillsWithRuns(packed, size);
        if (part_.compression == kDwaa || part_.compression == kDwab) return fillsWithDwa(packed, part_, box);
        if (part_.compression != kZip && part_.compression != kZips) return true;
        unpacked_.resize(static_cast<std::size_t>(size));
        auto length = static_cast<uLongf>(size);
        const int code =
            ::uncompress(unpacked_.data(), &length, reinterpret_cast<const Bytef*>(packed.data()),
                         static_cast<uLong>(packed.size()));
        if (code == Z_MEM_ERROR) throw std::bad_alloc();
        return code == Z_OK && length == static_cast<uLongf>(size);
    }

    template <class T>
    T numberAt(std::size_t offset) const {
        if (offset > file_.size() || sizeof(T) > file_.size() - offset)
            throwDamaged(name_, "unexpected end of file");
        T value;
        std::memcpy(&value, file_.data() + offset, sizeof value);
        return value;
    }

    FileBytes file_;
    const ExrFile& headers_;
    std::size_t number_;
    const ExrPart& part_;
    const std::string& name_;
    std::vector<Bytef> unpacked_;
};

}  // namespace

ExrSamples samplesOf(const ExrChannel& channel, const ExrBox& box) {
    return {multiples(box.left, box.right, channel.xSampling),
            multiples(box.top, box.bottom, channel.ySampling)};
}

long long sampleSize(const ExrChannel& channel) { return channel.type == 1 ? 2 : 4; }

void checkExrBlocks(FileBytes file, const ExrFile& headers, std::size_t part, const std::string& name) {
    BlockChecker(file, headers, part, name).run();
}

}  // namespace rayscope::image
