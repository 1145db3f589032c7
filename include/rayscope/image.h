#pragma once
#include <rayscope/diagnostics.h>
#include <rayscope/vector.h>
#include <cstddef>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayscope {

/// Throws OutOfMemory (memory.h) unless there is memory for an image of this size.
void requireImageMemory(int width, int height, std::size_t bytesPerPixel);

/// A rectangle of pixels, row by row from the top left corner; pixels.size() == width * height.
template <class Pixel>
struct Image {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    /// Throws std::invalid_argument if the width or height is negative, and OutOfMemory (memory.h).
    Image(int w, int h, Pixel fill = Pixel{}) : width(w), height(h) {
        if (w < 0 || h < 0) throw std::invalid_argument("image: negative width or height");
        requireImageMemory(w, h, sizeof(Pixel));
        pixels.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill);
    }

    bool empty() const { return pixels.empty(); }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    Pixel& at(int x, int y) { return pixels[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

/// Whether pixels.size() == width * height.
template <class Pixel>
bool hasAllPixels(const Image<Pixel>& image) {
    return image.width >= 0 && image.height >= 0 &&
           image.pixels.size() ==
               static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

using RgbImage = Image<Rgb>;

/// Name and value pairs stored in an image file: settings, seed, version.
using ImageMetadata = std::map<std::string, std::string>;

/// How linear values become the bytes of an 8-bit file.
enum class Encoding {
    Srgb,  ///< the piecewise curve of IEC 61966-2-1
    None   ///< clamp and truncate, to compare with images of programs without colour management
};

/// The limit of width times height for images that are read or rendered. Files that announce more are refused
/// before memory is allocated.
inline constexpr long long kMaxImagePixels = 1LL << 28;

/// Reads PNG, JPEG, BMP, TGA, HDR, EXR, PFM and PNM files into linear values; the format is detected from the
/// content, and docs/formats.md lists what is read of each. Integer samples are decoded with the sRGB curve,
/// unless the file states another one; alpha is ignored. Appends to `notes`, unless it is null, what was
/// ignored or approximated and what is odd about the file. Throws InputError if the file is missing, empty,
/// damaged, in another format or larger than kMaxImagePixels, and OutOfMemory (memory.h).
RgbImage readImage(const std::string& path, Diagnostics* notes = nullptr);

/// readImage() for a file in memory; `name` is its name in messages.
RgbImage decodeImage(std::span<const std::byte> file, const std::string& name, Diagnostics* notes = nullptr);

/// Writes the format of the suffix: .png, .ppm and .pgm (8 bits, with `encoding`; .pgm holds the luminance),
/// .exr, .pfm and .hdr (linear). Metadata is stored in .png and .exr, under names with the prefix
/// "rayscope:"; the other formats cannot store it. NaN, infinite and negative values are kept in .exr and
/// .pfm. In the 8-bit formats infinity becomes 255, in .hdr the largest value of the format; NaN and negative
/// values become 0 in both. Replaces an existing file atomically. Throws InputError if the image is empty,
/// the suffix is unknown or the file cannot be written, and std::invalid_argument unless hasAllPixels().
void writeImage(const std::string& path, const RgbImage& image, const ImageMetadata& metadata = {},
                Encoding encoding = Encoding::Srgb);

/// The file that writeImage() would write, for a suffix such as ".png". Throws InputError if it is unknown or
/// the image is empty, and std::invalid_argument unless hasAllPixels().
std::string encodeImage(const std::string& suffix, const RgbImage& image, const ImageMetadata& metadata = {},
                        Encoding encoding = Encoding::Srgb);

/// Throws InputError unless writeImage() could write `path`: a known suffix and a writable folder.
void checkImageDestination(const std::string& path);

}  // namespace rayscope
