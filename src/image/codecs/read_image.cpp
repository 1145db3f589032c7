#include <fmt/format.h>

#include <rayscope/diagnostics.h>

#include "base/read_file.h"
#include "image/codecs/codecs.h"

namespace rayscope::image {

void checkImageSize(long long width, long long height, std::size_t fileSize, const std::string& name) {
    if (width < 1 || height < 1) throwDamaged(name, fmt::format("its size is {} x {} pixels", width, height));
    if (width > kMaxImagePixels / height)
        throw InputError(fmt::format("image too large: {} x {} pixels, the limit is {} (2^28); scale it down",
                                     width, height, kMaxImagePixels),
                         {name});
    // Deflate, the densest of the codecs, reaches 1032:1: 8256 pixels of one bit per byte, and a few times
    // that where a codec stores one value per block of pixels.
    constexpr long long kMaxPixelsPerByte = 1LL << 16;
    if (width * height / kMaxPixelsPerByte > static_cast<long long>(fileSize))
        throwDamaged(name, fmt::format("{} x {} pixels in a file of {} bytes", width, height, fileSize));
}

void throwDamaged(const std::string& name, const std::string& reason) {
    throw InputError(fmt::format("damaged or truncated image ({}); export or copy it again", reason), {name});
}

}  // namespace rayscope::image

namespace rayscope {

RgbImage readImage(const std::string& path) {
    const std::string file = base::readFile(path);
    return decodeImage(std::as_bytes(std::span(file)), path);
}

RgbImage decodeImage(std::span<const std::byte> file, const std::string& name) {
    if (file.empty()) throw InputError("empty image file (0 bytes); export it again", {name});
    if (image::looksLikeExr(file)) return image::decodeExr(file, name);
    if (image::looksLikePfm(file)) return image::decodePfm(file, name);
    return image::decodeStb(file, name);
}

}  // namespace rayscope
