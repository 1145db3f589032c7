#include "image/codecs/embedded_metadata.h"

#include <string_view>

#include "image/codecs/byte_cursor.h"

namespace rayscope::image {

namespace {

/// The value of tag Orientation in the first directory, 1 (upright) if there is none.
std::uint32_t orientationOf(FileBytes exif) {
    constexpr std::size_t kHeader = 8, kEntry = 12;
    constexpr std::uint32_t kOrientationTag = 0x0112;
    if (exif.size() < kHeader) return 1;
    const bool little = byteAt(exif, 0) == 'I';
    const auto read16 = [&](std::size_t at) {
        return little ? littleEndian16(exif, at) : bigEndian16(exif, at);
    };
    const std::size_t directory = little ? littleEndian32(exif, 4) : bigEndian32(exif, 4);
    if (directory > exif.size() || exif.size() - directory < 2) return 1;
    const std::size_t count = read16(directory);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + 2 + i * kEntry;
        if (exif.size() < entry + kEntry) return 1;
        if (read16(entry) == kOrientationTag) return read16(entry + 8);
    }
    return 1;
}

}  // namespace

void noteIccProfile(const ImageFile& file, FileBytes profile) {
    using namespace std::string_view_literals;
    const std::string_view text(reinterpret_cast<const char*>(profile.data()), profile.size());
    if (text.find("sRGB"sv) != std::string_view::npos || text.find("s\0R\0G\0B"sv) != std::string_view::npos)
        return;
    file.note("the ICC profile is ignored: the colours are read as sRGB");
}

void noteExifOrientation(const ImageFile& file, FileBytes exif) {
    const std::uint32_t orientation = orientationOf(exif);
    if (orientation >= 2 && orientation <= 8)
        file.warn(
            "the image is meant to be shown rotated or mirrored (EXIF orientation), which is ignored; save "
            "it "
            "upright");
}

}  // namespace rayscope::image
