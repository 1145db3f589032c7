#pragma once
#include <rayscope/image.h>
#include <cmath>
#include <cstdint>
#include <initializer_list>
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

inline RgbImage decode(const std::string& file, const std::string& name = "memory",
                       Diagnostics* notes = nullptr) {
    return decodeImage(std::as_bytes(std::span(file)), name, notes);
}

/// What decoding the file reports, one line per note.
inline std::string notesOf(const std::string& file) {
    Diagnostics notes;
    decode(file, "x.img", &notes);
    std::string lines;
    for (const Diagnostic& note : notes) lines += toString(note) + "\n";
    return lines;
}

/// The linear value of a code of the sRGB curve, 0 … maximum.
inline float linearOf(double code, double maximum = 255.0) {
    const double encoded = code / maximum;
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

inline Rgb linearOf(int red, int green, int blue) { return {linearOf(red), linearOf(green), linearOf(blue)}; }

/// The number in `count` bytes, also more than 4.
inline std::string littleEndian(std::uint32_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(i < 4 ? value >> (8 * i) & 255 : 0);
    return bytes;
}
inline std::string bigEndian(std::uint32_t value, int count) {
    std::string bytes = littleEndian(value, count);
    return {bytes.rbegin(), bytes.rend()};
}

/// The bytes with these values.
inline std::string bytesOf(std::initializer_list<int> values) {
    std::string bytes;
    for (const int value : values) bytes += static_cast<char>(value);
    return bytes;
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
