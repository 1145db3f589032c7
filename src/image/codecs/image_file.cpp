#include "image/codecs/image_file.h"

#include <fmt/format.h>
#include <rayscope/image.h>

#include <utility>

#include "base/memory_budget.h"
#include "base/printable_text.h"

namespace rayscope::image {

void ImageFile::note(std::string message) const {
    if (notes) notes->push_back({Severity::Note, std::move(message), {name}});
}

void ImageFile::warn(std::string message) const {
    if (notes) notes->push_back({Severity::Warning, std::move(message), {name}});
}

void ImageFile::refuse(std::string message) const { throw InputError(std::move(message), {name}); }

void ImageFile::damaged(const std::string& reason) const { throwDamaged(name, reason); }

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
    base::requireMemory(static_cast<std::uint64_t>(width * height) * sizeof(Rgb), "a smaller image",
                        "{} with {} x {} pixels", base::printable(name), width, height);
}

void throwDamaged(const std::string& name, const std::string& reason) {
    throw InputError(fmt::format("damaged or truncated image ({}); export or copy it again", reason), {name});
}

}  // namespace rayscope::image
