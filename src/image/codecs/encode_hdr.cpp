#include <stb_image_write.h>

#include "image/codecs/codecs.h"

namespace rayscope::image {

std::string encodeHdr(const RgbImage& image) {
    std::string file;
    const auto append = [](void* bytes, void* data, int size) {
        static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                                 static_cast<std::size_t>(size));
    };
    stbi_write_hdr_to_func(append, &file, image.width, image.height, 3, &image.pixels.data()->x);
    return file;
}

}  // namespace rayscope::image
