#include <fmt/format.h>

#include <rayscope/diagnostics.h>

#include "base/read_file.h"
#include "image/codecs/codecs.h"

namespace rayscope::image {

void checkImageSize(long long width, long long height, const std::string& name) {
    if (width < 1 || height < 1) throwDamaged(name, fmt::format("its size is {} x {} pixels", width, height));
    if (width > kMaxImagePixels / height)
        throw InputError(
            fmt::format("the image has {} x {} pixels, more than the limit of {} (2^26) in all; scale it "
                        "down",
                        width, height, kMaxImagePixels),
            {name});
}

void throwDamaged(const std::string& name, const std::string& why) {
    throw InputError(fmt::format("the image is damaged or cut short ({}); export or copy it again", why),
                     {name});
}

}  // namespace rayscope::image

namespace rayscope {

RgbImage readImage(const std::string& path) {
    const std::string file = base::readFile(path);
    return decodeImage(std::as_bytes(std::span(file)), path);
}

RgbImage decodeImage(std::span<const std::byte> file, const std::string& name) {
    if (file.empty()) throw InputError("the image file is empty (0 bytes); export it again", {name});
    if (image::looksLikeExr(file)) return image::decodeExr(file, name);
    if (image::looksLikePfm(file)) return image::decodePfm(file, name);
    return image::decodeStb(file, name);
}

}  // namespace rayscope
