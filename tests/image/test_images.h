#pragma once
#include <rayscope/image.h>
#include <cstdint>
#include <span>
#include <string>

namespace rayscope::test {

/// A small image with distinct pixels; values reach `brightest`.
inline RgbImage gradient(int width, int height, float brightest = 1.0f) {
    RgbImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) =
                brightest * Rgb(static_cast<float>(x + 1) / static_cast<float>(width),
                                static_cast<float>(y + 1) / static_cast<float>(height),
                                static_cast<float>(x + y * width) / static_cast<float>(width * height));
    return image;
}

inline RgbImage decode(const std::string& file, const std::string& name = "memory") {
    return decodeImage(std::as_bytes(std::span(file)), name);
}

inline std::uint32_t bigEndianAt(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

/// The codes 0 … 255 as an opaque grey 16 × 16 image: three bytes per pixel, row by row.
inline std::string allCodes() {
    std::string bytes;
    for (int code = 0; code < 256; ++code) bytes.append(3, static_cast<char>(code));
    return bytes;
}

/// The file that `write` makes, one of stbi_write_…_to_func with its last arguments bound.
template <class Write>
std::string stbFile(Write write) {
    std::string file;
    void (*append)(void*, void*, int) = [](void* target, void* data, int size) {
        static_cast<std::string*>(target)->append(static_cast<const char*>(data),
                                                  static_cast<std::size_t>(size));
    };
    write(append, &file);
    return file;
}

}  // namespace rayscope::test
