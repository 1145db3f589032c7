#include "image/codecs/jpeg_markers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "image/codecs/byte_cursor.h"
#include "image/codecs/embedded_metadata.h"

namespace rayscope::image {

namespace {

using namespace std::string_view_literals;

constexpr std::uint32_t kStartOfImage = 0xd8, kEndOfImage = 0xd9, kStartOfScan = 0xda, kDefineHeight = 0xdc;

/// Whether a marker stands alone, without a length and data: restarts, TEM, start of image.
bool isBare(std::uint32_t marker) { return (marker >= 0xd0 && marker <= kStartOfImage) || marker == 0x01; }

/// Start of frame SOF0 … SOF15, without the markers between them with other meanings: DHT, JPG, DAC.
bool startsFrame(std::uint32_t marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// The coding that is not read of a start of frame; "" if it is read.
std::string_view unreadCoding(std::uint32_t marker) {
    switch (marker) {
        case 0xc3:
            return "lossless coding";
        case 0xcb:
            return "lossless arithmetic coding";
        case 0xc5:
        case 0xc6:
        case 0xc7:
        case 0xcd:
        case 0xce:
        case 0xcf:
            return "hierarchical coding";
        default:
            return "";
    }
}

class MarkerScan {
  public:
    explicit MarkerScan(const ImageFile& file) : file_(file), bytes_(file.bytes) {}

    JpegLayout run() {
        while (nextMarker()) {
            if (marker_ == kEndOfImage) {
                layout_.hasEndMarker = true;
                break;
            }
            if (!isBare(marker_)) readSegment();
        }
        checkCompleteness();
        return layout_;
    }

  private:
    /// Moves behind the next marker; false at the end of the file. Skips what is no marker: the data of
    /// scans, in which 0xff is followed by 0, and fill bytes.
    bool nextMarker() {
        for (; at_ + 1 < bytes_.size(); ++at_) {
            if (byteAt(bytes_, at_) != 0xff) continue;
            marker_ = byteAt(bytes_, at_ + 1);
            if (marker_ == 0x00 || marker_ == 0xff) continue;
            at_ += 2;
            return true;
        }
        return false;
    }

    void readSegment() {
        if (bytes_.size() - at_ < 2) file_.damaged(kEndsTooEarly);
        const std::size_t length = bigEndian16(bytes_, at_);
        if (length < 2) file_.damaged(fmt::format("a segment has the length {}", length));
        if (length > bytes_.size() - at_) file_.damaged(kEndsTooEarly);
        const FileBytes data = bytes_.subspan(at_ + 2, length - 2);
        at_ += length;
        if (startsFrame(marker_)) readFrame(data);
        if (marker_ == 0xf7) file_.refuse("is a JPEG-LS image; convert it to PNG or EXR");
        if (marker_ == kStartOfScan) readScan(data);
        if (marker_ == kDefineHeight && !hasScan_) file_.damaged("a DNL marker before the first scan");
        if (marker_ == 0xe1 && textOf(data).starts_with("Exif\0\0"sv))
            noteExifOrientation(file_, data.subspan(6));
        constexpr std::size_t kIccHeader = 14;
        if (marker_ == 0xe2 && data.size() > kIccHeader && textOf(data).starts_with("ICC_PROFILE\0\1"sv))
            noteIccProfile(file_, data.subspan(kIccHeader));
    }

    void readFrame(FileBytes data) {
        if (components_ > 0) file_.damaged("two frame headers");
        if (const auto coding = unreadCoding(marker_); !coding.empty())
            file_.refuse(fmt::format(
                "is a JPEG image with {}, which is not read; convert it to PNG or a baseline JPEG", coding));
        if (data.size() < 6) file_.damaged("the frame header is too short");
        const std::uint32_t precision = byteAt(data, 0);
        if (precision != 8)
            file_.refuse(fmt::format(
                "is a JPEG image with {} bits per sample, of which only 8 are read; convert it to "
                "PNG or EXR",
                precision));
        layout_.height = static_cast<int>(bigEndian16(data, 1));
        layout_.width = static_cast<int>(bigEndian16(data, 3));
        components_ = byteAt(data, 5);
        if (components_ != 1 && components_ != 3 && components_ != 4)
            file_.refuse(fmt::format(
                "is a JPEG image with {} components, of which only 1, 3 and 4 are read; convert it "
                "to PNG or EXR",
                components_));
        if (data.size() < 6 + 3 * components_) file_.damaged("the frame header is too short");
        for (std::uint32_t i = 0; i < components_; ++i) ids_[i] = byteAt(data, 6 + 3 * i);
        if (layout_.height == 0)
            file_.refuse(
                "is a JPEG image whose height follows its pixels (DNL), which is not read; save it again");
        checkImageSize(layout_.width, layout_.height, bytes_.size(), file_.name);
        const bool arithmetic = marker_ == 0xc9 || marker_ == 0xca;
        if (!arithmetic && minimumBits(data) / 8 > static_cast<long long>(bytes_.size()))
            file_.damaged(fmt::format("{} x {} pixels in a file of {} bytes", layout_.width, layout_.height,
                                      bytes_.size()));
        layout_.progressive = marker_ == 0xc2 || marker_ == 0xca;
    }

    /// Huffman code has at least one bit for each block of 8 × 8 samples.
    long long minimumBits(FileBytes frame) const {
        std::uint32_t maxHorizontal = 1, maxVertical = 1;
        const auto horizontal = [&](std::uint32_t i) { return byteAt(frame, 7 + 3 * i) >> 4; };
        const auto vertical = [&](std::uint32_t i) { return byteAt(frame, 7 + 3 * i) & 15; };
        for (std::uint32_t i = 0; i < components_; ++i) {
            maxHorizontal = std::max(maxHorizontal, horizontal(i));
            maxVertical = std::max(maxVertical, vertical(i));
        }
        long long blocks = 0;
        for (std::uint32_t i = 0; i < components_; ++i)
            blocks += (static_cast<long long>(layout_.width) * horizontal(i) / maxHorizontal / 8) *
                      (static_cast<long long>(layout_.height) * vertical(i) / maxVertical / 8);
        return blocks;
    }

    void readScan(FileBytes data) {
        if (components_ == 0) file_.damaged("a scan without a frame header");
        const std::size_t count = data.empty() ? 0 : byteAt(data, 0);
        if (data.size() < 4 + 2 * count) file_.damaged("a scan header is too short");
        hasScan_ = true;
        constexpr int kMaxScans = 500;  // each costs the time of the whole image; real files have about 10
        if (++scans_ > kMaxScans)
            file_.refuse(fmt::format("has more than {} scans; save it again", kMaxScans));
        const bool startsAtDc = byteAt(data, 1 + 2 * count) == 0;
        for (std::size_t i = 0; i < count; ++i)
            for (std::uint32_t k = 0; k < components_; ++k)
                if (startsAtDc && ids_[k] == byteAt(data, 1 + 2 * i)) covered_[k] = true;
    }

    void checkCompleteness() const {
        if (components_ == 0) file_.damaged("it has no frame header");
        if (!hasScan_) file_.damaged("it ends before the first scan");
        for (std::uint32_t k = 0; k < components_; ++k)
            if (!covered_[k]) file_.damaged(fmt::format("it has no scan of component {}", k + 1));
        if (!layout_.hasEndMarker && layout_.progressive) file_.damaged(kEndsTooEarly);
    }

    const ImageFile& file_;
    FileBytes bytes_;
    std::size_t at_ = 0;
    std::uint32_t marker_ = 0, components_ = 0;
    std::array<std::uint32_t, 4> ids_{};
    std::array<bool, 4> covered_{};
    bool hasScan_ = false;
    int scans_ = 0;
    JpegLayout layout_;
};

}  // namespace

JpegLayout checkJpegMarkers(const ImageFile& file) { return MarkerScan(file).run(); }

}  // namespace rayscope::image
